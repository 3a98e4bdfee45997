#include "verification/case_file/case_parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "verification/case/changed_input.hpp"
#include "verification/case/ensemble.hpp"
#include "verification/case/shape/tank_shape.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/key_table.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/input/input_files.hpp"
#include "verification/input/toml_reader.hpp"

namespace slosh {
namespace {

constexpr int case_schema_version = 1;

template <class Definition>
void add_named(const TomlTable& table, const char* key, Definition definition,
               std::vector<Definition>& definitions) {
  for (const Definition& other : definitions)
    if (other.name == definition.name)
      table.refuse("name", fmt::format("a name that no other {} has", key));
  definitions.push_back(std::move(definition));
}

// The names of tables that were refused. Other tables that refer to them are not checked, as their
// mistakes may only follow from the refusal.
class RefusedNames {
 public:
  void add(const TomlTable& table) { names_.insert(table.written("name")); }
  void add_any() { names_.insert(""); }
  bool empty() const { return names_.empty(); }
  // If the name of a refused table could not be read, every name may be its name.
  bool hold(const std::string& name) const { return names_.contains("") || names_.contains(name); }
  // Whether a quantity, such as "elevation@GAUGE", is measured at a refused gauge.
  bool measure(const std::string& quantity) const {
    return std::any_of(names_.begin(), names_.end(), [&](const std::string& name) {
      return quantity.find("@" + name) != std::string::npos;
    });
  }

 private:
  std::set<std::string> names_;
};

// Returns what `read` makes of the table. Throws as read_all() does.
template <class Read>
auto read_whole(const TomlTable& table, Read read) {
  std::optional<decltype(read(table))> made;
  table.read_all([&](const TomlTable& keeping) { made = read(keeping); });
  return std::move(*made);
}

// Reads a case section by section. Refusals are collected, and a section is read only if everything
// that its rules depend on has been read, so that no mistake is reported twice.
class CaseReader {
 public:
  CaseReader(const TomlTable& root, CaseDefinition& definition)
      : root_(root), definition_(definition) {}

  // Throws CaseFileErrors.
  void read() {
    read_head();
    read_tank_and_time();
    read_gauges();
    read_what_shapes_the_flow();
    read_comparison();
    read_runs();
    read_what_names_runs();
    complaints_.tell();
  }

 private:
  template <class Read>
  bool allow(Read read) {
    return complaints_.allow(read);
  }

  // Reads what stands at the key. A missing key is not reported beside unknown keys: one of these
  // may be its misspelling.
  template <class Read>
  bool allow_at(const std::string& key, Read read) {
    return (root_.has(key) || only_known_keys_) && allow(read);
  }

  // Makes the part of the definition that stands in the table at the key.
  template <class Part, class Read>
  bool section(const char* key, Part& part, const Read& read) {
    return allow_at(key, [&] { part = whole(root_.table(key), read); });
  }

  // Reads the table at the key into the definition itself.
  bool part(const char* key, const FieldTable<CaseDefinition>& keys) {
    return allow_at(key, [&] {
      root_.table(key).read_all(
          [&](const TomlTable& table) { keys.read_into(table, definition_, definition_); });
    });
  }

  // What `read` makes of the table and of what has been read of the case.
  template <class Read>
  auto whole(const TomlTable& table, const Read& read) {
    return read_whole(table, [&](const TomlTable& one) { return read(one, definition_); });
  }

  // Reads each [[key]], and returns whether all of them could be read.
  template <class Read>
  bool each(const char* key, Read read) {
    std::vector<TomlTable> tables;
    bool all = allow([&] { tables = root_.tables(key); });
    for (const TomlTable& table : tables) all = allow([&] { read(table); }) && all;
    return all;
  }

  // Reads each [[key]] as a definition with a unique name.
  template <class Definition, class Read>
  bool each_named(const char* key, std::vector<Definition>& definitions, const Read& read,
                  RefusedNames* refused = nullptr) {
    return each(key, [&](const TomlTable& table) {
      try {
        add_named(table, key, whole(table, read), definitions);
      } catch (const CaseFileError&) {
        if (refused) refused->add(table);
        throw;
      }
    });
  }

  void read_head() {
    only_known_keys_ = allow([&] { root_.allow_only(case_keys.names()); });
    std::set<std::string> refused;
    for (const Field<CaseDefinition>& row : case_keys.fields)
      if (row.read && !allow_at(row.name, [&] { row.read(row, root_, definition_, definition_); }))
        refused.insert(row.name);
    gravity_ = !root_.has("gravity_m_s2") || !refused.contains("gravity_m_s2");
    wall_forces_ = !root_.has("wall_forces") || !refused.contains("wall_forces");
  }

  void read_tank_and_time() {
    tank_ = section("tank", definition_.tank, tank_keys);
    if (tank_ && !is_rectangle(definition_.tank))
      tank_ = allow([&] { refuse_beside_outline(root_, definition_); });
    liquid_ = tank_ && section("liquid", definition_.liquid, liquid_keys);
    if (liquid_) allow([&] { read_gas(); });
    time_ = part("time", time_keys);
    if (time_ && root_.has("animation")) {
      Animation animation{};
      section("animation", animation, animation_keys);
      definition_.animation_times = animation.times;
    }
    motion_ = tank_ && time_ && section("motion", definition_.motion, motion_keys);
    if (gravity_ && motion_ && definition_.gravity == 0 && definition_.motion.still())
      allow([&] {
        root_.refuse("gravity_m_s2",
                     "a number > 0, in m/s2, for a still tank: otherwise nothing moves");
      });
  }

  void read_gas() {
    definition_.gas = air;
    if (root_.has("gas") || !(air.density < definition_.liquid.density))
      definition_.gas = whole(root_.table("gas"), gas_keys);
  }

  // At least one gauge of either kind is required.
  void read_gauges() {
    if (!tank_ || !time_ || !(liquid_ || is_rectangle(definition_.tank))) return;
    gauges_ = each_named("gauge", definition_.gauges, gauge_keys, &refused_gauges_);
    gauges_ &= each_named("pressure_gauge", definition_.pressure_gauges, pressure_gauge_keys,
                          &refused_gauges_);
    gauges_ &= each_named("probe", definition_.probes, probe_keys, &refused_gauges_);
    gauges_ &= wall_forces_;
    if (gauges_ && definition_.gauges.empty() && definition_.pressure_gauges.empty())
      gauges_ = allow_at(
          "gauge", [&] { root_.refuse("gauge", "at least one [[gauge]] or [[pressure_gauge]]"); });
    if (!gauges_ && refused_gauges_.empty()) refused_gauges_.add_any();
  }

  // An unknown key may be any of the optional sections, misspelt.
  void read_what_shapes_the_flow() {
    impacts_ = only_known_keys_ && gauges_ &&
               (!root_.has("impacts") || section("impacts", definition_.impacts, impacts_keys));
    obstacles_ = liquid_ && gauges_ &&
                 each_named("obstacle", definition_.obstacles, obstacle_keys) &&
                 allow([&] { refuse_overlaps(root_.tables("obstacle"), definition_.obstacles); });
    wave_ = only_known_keys_ &&
            (!root_.has("initial_wave") ||
             (obstacles_ && section("initial_wave", definition_.initial_wave, initial_wave_keys)));
  }

  void read_comparison() {
    comparison_ = gravity_ && liquid_ && motion_ && wave_ && part("comparison", comparison_keys) &&
                  allow([&] { refuse_breadth_of_outline(root_, definition_); });
  }

  // Records and external programs refer to gauges.
  bool can_judge_run(const TomlTable& run) const {
    const SolverKind* kind = find_solver_kind(run.written("solver"));
    const bool of_gauges = kind && kind->declares_quantities;
    const bool in_plain_tank = !root_.has("obstacle") || obstacles_;
    return liquid_ && motion_ && wave_ && in_plain_tank && (gauges_ || !of_gauges);
  }

  void read_run(const TomlTable& table) {
    if (!can_judge_run(table)) return refused_runs_.add(table);
    try {
      const auto read = [&](const TomlTable& run) {
        refuse_solver_of_outline(run, definition_);
        std::vector<RunDefinition> runs = slosh::read_runs(run, definition_);
        if (runs.front().varies_inputs && !root_.has("input"))
          run.refuse("vary_inputs", "no such key without an [[input]]: there is nothing to draw");
        return runs;
      };
      for (const RunDefinition& run : read_whole(table, read))
        add_named(table, "run", run, definition_.runs);
    } catch (const CaseFileError&) {
      refused_runs_.add(table);
      throw;
    }
  }

  void read_runs() {
    runs_ = each("run", [&](const TomlTable& group) {
      std::vector<TomlTable> runs;
      if (!allow([&] { runs = runs_of_group(group); })) refused_runs_.add_any();
      for (const TomlTable& run : runs) allow([&] { read_run(run); });
    });
    runs_ &= refused_runs_.empty();
    if (runs_ && definition_.runs.empty())
      runs_ = allow_at("run", [&] { root_.refuse("run", "at least one [[run]]"); });
    if (!runs_ && refused_runs_.empty()) refused_runs_.add_any();
  }

  // Without the refused runs a pattern may match none.
  bool can_judge_group(const TomlTable& group) const {
    return refused_runs_.empty() || !group.has("candidates");
  }

  bool can_judge_row(const TomlTable& row) const {
    for (const char* key : {"candidate", "reference", "improves_on"})
      if (refused_runs_.hold(row.written(key))) return false;
    const bool of_impacts = root_.has("impacts");
    const bool gauge_is_read = row.has("quantity")
                                   ? !refused_gauges_.measure(row.written("quantity"))
                                   : refused_gauges_.empty();
    return comparison_ && (impacts_ || !of_impacts) && gauge_is_read;
  }

  void read_row(const TomlTable& row) {
    allow([&] {
      if (can_judge_row(row)) definition_.gate.push_back(whole(row, gate_keys));
    });
  }

  void read_what_names_runs() {
    bool inputs = false;
    if (runs_) {
      each_named("refinement", definition_.refinements, refinement_keys);
      inputs = comparison_ && each("input", [&](const TomlTable& input) {
                 definition_.inputs.push_back(whole(input, input_keys));
               });
    }
    each("gate", [&](const TomlTable& group) {
      if (can_judge_group(group))
        for (const TomlTable& row : gate_rows(group, definition_)) read_row(row);
    });
    if (inputs) {
      draw_inputs(definition_);
      allow([&] { add_runs_at_ends(); });
    }
  }

  // These runs are added last, so that neither a gate row nor a refinement can name them.
  void add_runs_at_ends() {
    for (const InputUncertainty& input : definition_.inputs) {
      if (input.coarse_run.empty()) continue;
      for (const RunDefinition& run : runs_at_ends(input, run_named(definition_, input.coarse_run)))
        add_named(root_, "run", run, definition_.runs);
    }
  }

  const TomlTable& root_;
  CaseDefinition& definition_;
  Complaints complaints_;
  // Whether each section was read, or is optional and absent.
  bool only_known_keys_ = false, gravity_ = false, wall_forces_ = false, tank_ = false,
       liquid_ = false, time_ = false, motion_ = false, gauges_ = false, impacts_ = false,
       obstacles_ = false, wave_ = false, comparison_ = false, runs_ = false;
  RefusedNames refused_gauges_, refused_runs_;
};

}  // namespace

CaseDefinition read_case(const std::filesystem::path& file,
                         const std::filesystem::path& experiments) {
  CaseDefinition definition{};
  definition.file = file;
  definition.experiments = experiments;
  definition.gravity = usual_gravity;
  definition.text = read_definition_text("case", file);
  const TomlTable root(definition.text, file);
  root.get("schema_version", exactly(case_schema_version));  // another version has other rules
  CaseReader(root, definition).read();
  return definition;
}

std::filesystem::path find_case(const std::string& name_or_path,
                                const std::filesystem::path& directory) {
  return find_definition_file("case", name_or_path, directory, "");
}

}  // namespace slosh
