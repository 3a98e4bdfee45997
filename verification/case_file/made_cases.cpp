#include "verification/case_file/made_cases.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "verification/case/solver_kinds.hpp"
#include "verification/case_file/case_sections.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/input/nearest_name.hpp"
#include "verification/input/toml_reader.hpp"

namespace slosh {
namespace {

constexpr std::size_t least_spacings = 3;  // needed to estimate an order

void require_spacings(const std::vector<double>& spacings) {
  const bool positive =
      std::all_of(spacings.begin(), spacings.end(), [](double one) { return one > 0; });
  const std::set<double> different(spacings.begin(), spacings.end());
  if (spacings.size() < least_spacings || !positive || different.size() != spacings.size())
    throw CaseFileError(
        fmt::format("spacings = {}: expected three numbers or more, each > 0 and given once, in m",
                    fmt::join(spacings, ", ")));
}

// A study has single runs, of the case as it is.
toml::table single_run(const TomlTable& run) {
  return toml::parse(run.without({"repeats", "quick_repeats", "vary_inputs"}).as_toml());
}

// Returns the table of the run in the file. Throws CaseFileError with the nearest names.
toml::table run_table(const std::vector<TomlTable>& runs, const char* role, const std::string& name,
                      const CaseDefinition& definition) {
  std::vector<std::string> known;
  for (const TomlTable& run : runs) {
    known.push_back(run.written("name"));
    if (known.back() == name) return single_run(run);
  }
  constexpr std::size_t suggestions = 3;
  throw CaseFileError(fmt::format("{}: {} = {}: expected a run of the case; nearest: {}",
                                  definition.file.string(), role, name,
                                  fmt::join(nearest_names(name, known, suggestions), ", ")));
}

std::vector<TomlTable> declared_runs(const CaseDefinition& definition) {
  std::vector<TomlTable> runs;
  for (const TomlTable& group : TomlTable(definition.text, definition.file).tables("run"))
    for (TomlTable& run : runs_of_group(group)) runs.push_back(std::move(run));
  return runs;
}

toml::table pattern_run(const std::vector<TomlTable>& runs, const SpacingStudy& study,
                        const CaseDefinition& definition) {
  if (study.candidate.empty()) {
    for (const TomlTable& run : runs)
      if (run.has("method") && run.written("method") == study.family) return single_run(run);
    return toml::table{{"solver", "sph"}, {"scheme", study.family}};
  }
  toml::table run = run_table(runs, "candidate", study.candidate, definition);
  if (!run.contains("particle_spacing_m") || run.contains("surface_particle_spacing_m"))
    throw CaseFileError(fmt::format("{}: candidate = {}: expected a run of one particle spacing",
                                    definition.file.string(), study.candidate));
  return run;
}

void name_whole_command(toml::array& command, const std::filesystem::path& directory) {
  if (command.empty()) return;
  const std::string here = "{case_directory}";
  for (toml::node& argument : command) {
    std::string text = argument.value_or(std::string());
    for (std::size_t at = text.find(here); at != text.npos;
         at = text.find(here, at + directory.string().size()))
      text.replace(at, here.size(), directory.string());
    *argument.as_string() = text;
  }
  auto& program = *command.front().as_string();
  if (program.get().find('/') != std::string::npos)
    program = (directory / program.get()).lexically_normal().string();
}

// The place of a table beside the study. One whose name another has goes to a directory of its own.
std::filesystem::path place_of(const std::filesystem::path& source,
                               std::vector<StudyTable>& tables) {
  std::filesystem::path place = source.filename();
  for (const StudyTable& other : tables) {
    if (other.source == source) return other.place;
    if (other.place == place)
      place = std::filesystem::path(std::to_string(tables.size())) / source.filename();
  }
  tables.push_back({source, place});
  return place;
}

// The study's case file lies elsewhere: what is relative to the case's directory becomes absolute.
void name_whole_paths(toml::table& table, const CaseDefinition& definition,
                      std::vector<StudyTable>& tables) {
  const std::filesystem::path directory =
      absolute(definition.file).lexically_normal().parent_path();
  const auto whole = [&](const std::string& path) {
    return (directory / path).lexically_normal().string();
  };
  if (const auto path = table["file"].value<std::string>())
    table.insert_or_assign("file", place_of(whole(*path), tables).string());
  if (const auto path = table["directory"].value<std::string>())
    table.insert_or_assign("directory", whole(*path));
  if (toml::array* inputs = table["inputs"].as_array())
    for (toml::node& input : *inputs)
      if (auto* path = input.as_string()) *path = whole(path->get());
  for (const char* key : {"command", "version_command"})
    if (toml::array* command = table[key].as_array()) name_whole_command(*command, directory);
}

// Breaks a text into comment lines of at most 100 columns.
std::string comment(const std::string& text) {
  constexpr std::size_t columns = 100;
  std::istringstream stream(text);
  std::string lines, line = "#";
  for (std::string word; stream >> word;) {
    if (line.size() + 1 + word.size() > columns) {
      lines += line + "\n";
      line = "#";
    }
    line += " " + word;
  }
  return lines + line + "\n";
}

const RunDefinition& kept_simulation(const CaseDefinition& like) {
  const RunDefinition* kept = nullptr;
  bool is_judged = false;
  for (const RunDefinition& run : like.runs) {
    if (!solver_kind(run).has_particles || !run.ensemble.empty() || run.at_input) continue;
    const bool judged = std::any_of(like.gate.begin(), like.gate.end(), [&](const GateRow& row) {
      return row.candidate == run.name && row.limit;
    });
    if (kept &&
        (is_judged > judged || (is_judged == judged && resolution(*kept) <= resolution(run))))
      continue;
    kept = &run;
    is_judged = judged;
  }
  if (!kept)
    throw CaseFileError(
        like.file.string() +
        ": run: expected an SPH run that is no ensemble, to be kept in the new case");
  return *kept;
}

bool stays(const RunDefinition& run) {
  const auto* record = std::get_if<RecordRun>(&run.solver);
  return is_theory(run) || (record && record->supplied && !record->earlier_run);
}

// Writes tables with a comment on each key where it stands for the first time in the file.
class CommentedTables {
 public:
  // `heading` is empty for the top level.
  void add(const toml::table& table, const std::string& heading) {
    const std::vector<const KeyTable*> tables =
        tables_of(heading, table["solver"].value_or(std::string()));
    text_ += "\n";
    std::string absent;
    for (const KeyTable* keys : tables)
      if (!heading.empty() && !keys->meaning.empty() && told_.insert(keys->id).second)
        text_ += comment(keys->meaning);
    if (!heading.empty()) text_ += heading + "\n";
    for (const KeyTable* keys : tables)
      for (const KeyEntry& key : keys->keys) {
        if (key.value.is_table()) continue;
        const toml::node* node = table.get(key.name);
        if (told_.insert(keys->id + "." + key.name).second)
          (node ? text_ : absent) += comment((node ? "" : "Not here: ") + key.name + ": " +
                                             key.value.words() + ". " + key.meaning);
        std::ostringstream line;
        if (node) line << key.name << " = " << toml::toml_formatter(*node, quoted) << "\n";
        text_ += line.str();
      }
    text_ += absent;
    for (const KeyTable* keys : tables)
      for (const KeyEntry& key : keys->keys)
        if (key.value.is_table()) add_parts(table.get(key.name), key.value.heading);
  }
  const std::string& text() const { return text_; }

 private:
  // The tables of the keys: the table's own and, in a run, that of its solver.
  static std::vector<const KeyTable*> tables_of(const std::string& heading,
                                                const std::string& solver) {
    std::vector<const KeyTable*> tables;
    bool found = false;  // a record's first form is the shipped one
    for (const KeyTable& one : case_key_tables()) {
      const bool is_solvers = !found && std::ranges::count(one.solvers, solver) > 0;
      if (is_solvers || (heading.empty() ? one.id == "case" : one.heading == heading))
        tables.push_back(&one);
      found |= is_solvers;
    }
    return tables;
  }
  void add_parts(const toml::node* node, const std::string& heading) {
    if (!node) return;
    if (const toml::table* table = node->as_table()) add(*table, heading);
    if (const toml::array* array = node->as_array())
      for (const toml::node& element : *array) add(*element.as_table(), heading);
  }

  static constexpr toml::format_flags quoted =
      toml::toml_formatter::default_flags & ~toml::format_flags::allow_literal_strings;

  std::set<std::string> told_;
  std::string text_;
};

void name_whole_file(toml::table& table, const CaseDefinition& definition) {
  if (const auto file = table["file"].value<std::string>())
    table.insert_or_assign(
        "file", (absolute(definition.file).parent_path() / *file).lexically_normal().string());
}

}  // namespace

std::string study_run_name(const SpacingStudy& study, double spacing) {
  return fmt::format("{}_{}mm", study.candidate.empty() ? study.family : study.candidate + "_at",
                     millimetres_in_name(spacing));
}

StudyText spacing_study_text(const CaseDefinition& definition, const SpacingStudy& study) {
  require_spacings(study.spacings);
  toml::table root = toml::parse(definition.text);
  const std::vector<TomlTable> declared = declared_runs(definition);
  toml::table reference = run_table(declared, "reference", study.reference, definition);
  std::vector<StudyTable> tables;
  name_whole_paths(reference, definition, tables);
  toml::array runs{std::move(reference)}, names;
  for (const double spacing : study.spacings) {
    toml::table run = pattern_run(declared, study, definition);
    run.insert_or_assign("name", study_run_name(study, spacing));
    run.insert_or_assign("particle_spacing_m", spacing);
    name_whole_paths(run, definition, tables);
    names.push_back(study_run_name(study, spacing));
    runs.push_back(std::move(run));
  }
  root.insert_or_assign("run", std::move(runs));
  root.insert_or_assign("refinement", toml::array{toml::table{{"name", "spacing"},
                                                              {"number", "particle_spacing"},
                                                              {"runs", std::move(names)}}});
  root.erase("gate");
  root.erase("input");    // it serves gate rows only, and may name a run that the study lacks
  root.erase("impacts");  // they are compared with an experiment, which a study does not do
  for (const char* part : {"surge", "roll"})
    if (toml::table* motion = root["motion"][part].as_table())
      name_whole_paths(*motion, definition, tables);
  std::ostringstream text;
  text << root << "\n";
  return {text.str(), std::move(tables)};
}

std::string commented_case(const CaseDefinition& like, const std::string& name) {
  const Rule<std::string> rule = file_safe_name();
  if (!rule.holds(name)) throw CaseFileError("name = \"" + name + "\": expected " + rule.expected);
  const std::string candidate = kept_simulation(like).name;
  std::set<std::string> kept{"", candidate};
  for (const RunDefinition& run : like.runs)
    if (stays(run)) kept.insert(run.name);
  toml::array runs, rows;
  for (const TomlTable& run : declared_runs(like))
    if (kept.contains(run.written("name"))) {
      toml::table table = toml::parse(run.as_toml());
      name_whole_file(table, like);
      runs.push_back(std::move(table));
    }
  auto read = like.gate.begin();
  for (const TomlTable& group : TomlTable(like.text, like.file).tables("gate"))
    for (const TomlTable& row : gate_rows(group, like)) {
      const GateRow& one = *read++;
      if (one.candidate == candidate && kept.contains(one.reference) && !is_cost(one.metric) &&
          kept.contains(one.improves_on.value_or("")))
        rows.push_back(toml::parse(row.as_toml()));
    }
  toml::table root = toml::parse(like.text);
  for (const char* left_out : {"refinement", "input", "animation", "gate"}) root.erase(left_out);
  root.insert_or_assign("name", name);
  root.insert_or_assign("run", std::move(runs));
  if (!rows.empty()) root.insert_or_assign("gate", std::move(rows));
  for (const char* part : {"surge", "roll"})
    if (toml::table* motion = root["motion"][part].as_table()) name_whole_file(*motion, like);
  CommentedTables tables;
  tables.add(root, "");
  return comment("A case like " + like.name +
                 ": change its numbers, then try ./slosh explain. A key that may stand "
                 "here and does not is explained as \"Not here\".") +
         tables.text();
}

}  // namespace slosh
