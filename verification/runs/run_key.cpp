#include "verification/runs/run_key.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "openfoam_cases/run_case.hpp"
#include "verification/case/changed_input.hpp"
#include "verification/case/field_times.hpp"
#include "verification/case/gap_friction.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/files/protected_inputs.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/solvers/external/shared_libraries.hpp"
#include "verification/solvers/external_command.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;  // sorted objects and numbers in full: equal values have equal texts

json number_or_null(const std::optional<double>& number) {
  return number ? json(*number) : json(nullptr);
}

// A phase of 0 is left out, so that results of cases without a phase keep their key.
json description(const SineMotion& motion) {
  json sine{motion.amplitude, motion.angular_frequency, motion.ramp_periods};
  if (motion.phase != 0) sine.push_back(motion.phase);
  return {{"sine", sine}};
}
json description(const SumOfSines& motion) {
  json sines = json::array();
  for (const SineMotion& sine : motion.sines) sines.push_back(description(sine));
  return {{"sines", sines}};
}
json description(const TableMotion& motion) { return {{"table", {motion.time, motion.value}}}; }

template <class... Types>
json description(const std::variant<Types...>& choice) {
  return std::visit([](const auto& chosen) { return description(chosen); }, choice);
}

json description(const MotionDefinition& motion) {
  json surge = nullptr, roll = nullptr;
  if (motion.surge) surge = description(*motion.surge);
  if (motion.roll)
    roll = {description(motion.roll->angle), motion.roll->axis_x, motion.roll->axis_z};
  return {{"surge", surge}, {"roll", roll}};
}

json description(const PressureGaugeDefinition& gauge) {
  json described{gauge.name, static_cast<int>(gauge.wall), gauge.position, gauge.width,
                 number_or_null(gauge.filter_cutoff)};
  if (gauge.at) described.push_back({gauge.at->x, gauge.at->z});
  return described;
}

// An external program may read anything of the case.
bool reads_gas(const RunDefinition& run) {
  return sees_gas(run) || solver_kind(run).answered_with == AnsweredWith::user_program;
}

json physics(const CaseDefinition& definition) {
  json gauges = json::array();
  for (const GaugeDefinition& gauge : definition.gauges) gauges.push_back({gauge.name, gauge.x});
  json pressure_gauges = json::array();
  for (const PressureGaugeDefinition& gauge : definition.pressure_gauges)
    pressure_gauges.push_back(description(gauge));
  json obstacles = json::array();
  for (const ObstacleDefinition& one : definition.obstacles)
    obstacles.push_back({one.left, one.right, one.bottom, one.top});
  const LiquidDefinition& liquid = definition.liquid;
  json wave = nullptr;
  if (definition.initial_wave)
    wave = {definition.initial_wave->mode, definition.initial_wave->amplitude};
  json described{{"gravity", definition.gravity},
                 {"tank", {definition.tank.length, definition.tank.height}},
                 {"liquid", {liquid.fill_depth, liquid.density, liquid.kinematic_viscosity}},
                 {"column_width", number_or_null(liquid.column_width)},
                 {"obstacles", obstacles},
                 {"initial_wave", wave},
                 {"motion", description(definition.motion)},
                 {"start", definition.start == Start::earth ? "earth" : "tank"},
                 {"duration", definition.duration},
                 {"sample_interval", definition.sample_interval},
                 {"gauges", gauges},
                 {"pressure_gauges", pressure_gauges}};
  for (const ProbeDefinition& probe : definition.probes)
    described["probes"].push_back({probe.name, probe.x, probe.z});
  for (const Wall wall : definition.wall_forces)
    described["wall_forces"].push_back(name_of(wall, wall_names));
  for (const Corner& corner : definition.tank.outline)
    described["outline"].push_back({corner.x, corner.z});
  if (definition.tank.breadth)
    described["breadth"] = {*definition.tank.breadth, gap_friction(definition)};
  return described;
}

json content(const std::string& name, const fs::path& file) {
  return {name, content_hash(read_bytes(file))};
}

void add_directory(ContentHash& hash, const std::filesystem::path& directory) {
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(directory)) {
    if (entry.is_regular_file()) files.insert(entry.path());
  }
  for (const auto& file : files) {
    hash.add(
        json{file.lexically_relative(directory).string(), std::filesystem::file_size(file)}.dump());
    hash.add_file(file);
  }
}

const std::string& openfoam_version() {
  static const std::string version = openfoam::installed_version();  // starts interFoam
  return version;
}

// Of an external or a stored run: the files whose content is part of its key.
std::vector<fs::path> files_of(const RunDefinition& run, const CaseDefinition& definition) {
  if (const auto* stored = std::get_if<StoredRun>(&run.solver)) return stored_files(*stored);
  const auto* external = std::get_if<ExternalRun>(&run.solver);
  if (!external) return {};
  std::vector<fs::path> files{external_program(*external, definition)};
  for (InputFile& input : external_inputs(*external, definition)) files.push_back(input.file);
  std::ranges::move(own_libraries(*external, definition), std::back_inserter(files));
  return files;
}

// Adds all that determines the answer except an external run's program.
void add_answer(ContentHash& answer, const std::string& solver, const fs::path& builds,
                const fs::path& openfoam_templates) {
  const SolverKind* kind = find_solver_kind(solver);  // no kind: the file of the problems
  answer.add_file(builds / (kind && kind->build ? kind->build : solver));
  if (!kind || kind->answered_with != AnsweredWith::openfoam) return;
  answer.add(openfoam_version());
  add_directory(answer, openfoam_templates);
}

}  // namespace

std::string from_case_file(const fs::path& case_file, const fs::path& file) {
  const fs::path here = fs::current_path();
  return (here / file)
      .lexically_normal()
      .lexically_relative((here / case_file).lexically_normal().parent_path())
      .generic_string();
}

std::map<fs::path, std::string> files_read_by(const RunDefinition& run,
                                              const CaseDefinition& definition) {
  std::map<fs::path, std::string> contents;
  for (const fs::path& file : files_of(run, definition))
    if (fs::is_regular_file(file)) contents[file] = content_hash(read_bytes(file));
  return contents;
}

void require_unchanged(const std::map<fs::path, std::string>& contents) {
  for (const auto& [file, hash] : contents)
    if (!fs::is_regular_file(file) || content_hash(read_bytes(file)) != hash)
      throw SolverError(fmt::format(
          "{} changed while the run went on, so that it is not known which of its contents it "
          "read: expected a file that stays; what a program writes belongs in {{work_directory}}",
          file.string()));
}

void protect_inputs(const CaseDefinition& definition, const RunDefinition& run) {
  std::vector<fs::path> files = files_of(run, definition);
  if (const auto* external = std::get_if<ExternalRun>(&run.solver))
    for (const std::string& program : version_command(*external, definition, ""))
      if (fs::is_regular_file(program)) files.push_back(program);
  for (const fs::path& file : files) protect_input(file);
}

std::string run_key(const CaseDefinition& definition, const RunDefinition& run,
                    const std::filesystem::path& builds,
                    const std::filesystem::path& openfoam_templates) {
  protect_inputs(definition, run);
  ContentHash question, answer;
  json asked{{"case", physics(definition_solved_by(run, definition))},
             {"run", hashed_settings(run)}};
  if (reads_gas(run))
    asked["case"]["gas"] = {definition.gas.density, definition.gas.kinematic_viscosity};
  if (solver_kind(run).solves_flow) asked["snapshot_times"] = field_times(definition);
  const auto* external = std::get_if<ExternalRun>(&run.solver);
  if (external || is_stored(run)) asked["inputs"] = json::array();
  if (external && !external->directory.empty())
    asked["directory"] = from_case_file(definition.file, external->directory);
  if (external)
    for (const auto& [name, file] : external_inputs(*external, definition))
      asked["inputs"].push_back(content(name, file));
  if (const auto* stored = std::get_if<StoredRun>(&run.solver))
    for (const fs::path& file : stored_files(*stored))
      asked["inputs"].push_back(content(file.filename().string(), file));
  question.add(asked.dump());
  add_answer(answer, solver_name(run), builds, openfoam_templates);
  if (external) {
    const std::filesystem::path program = external_program(*external, definition);
    if (!program.empty()) answer.add_file(program);
    for (const fs::path& library : own_libraries(*external, definition)) answer.add_file(library);
  }
  return question.digits() + "-" + answer.digits();
}

std::string setup_hash(const CaseDefinition& definition, const std::set<std::string>& names) {
  json setup{{"case", physics(definition)}, {"runs", json::array()}};
  for (const RunDefinition& run : definition.runs)
    if (names.contains(run.name) || (!run.ensemble.empty() && names.contains(run.ensemble)))
      setup["runs"].push_back(hashed_settings(run));
  return content_hash(setup.dump());
}

PresentAnswers present_answers(const fs::path& builds, const fs::path& openfoam_templates) {
  PresentAnswers present;
  present.unknown_solvers.merge(solvers_answered_with(AnsweredWith::user_program));
  if (openfoam_version().empty())
    present.unknown_solvers.merge(solvers_answered_with(AnsweredWith::openfoam));
  for (const auto& build : fs::directory_iterator(builds)) {
    ContentHash answer;
    add_answer(answer, build.path().filename().string(), builds, openfoam_templates);
    present.answers.insert(answer.digits());
  }
  return present;
}

bool PresentAnswers::gave(std::string_view key) const {
  return answers.contains(std::string(key.substr(key.find('-') + 1)));
}

}  // namespace slosh
