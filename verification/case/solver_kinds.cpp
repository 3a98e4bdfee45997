#include "verification/case/solver_kinds.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "verification/case/quantities.hpp"

namespace slosh {
namespace {

using nlohmann::json;

constexpr SolverKind kind_of_foam(const char* name) {
  return {.name = name,
          .role = SolverRole::simulation,
          .answered_with = AnsweredWith::openfoam,
          .build = "interfoam",
          .elements = "cells",
          .solves_flow = true,
          .takes_time_limit = true,
          .takes_outline = true};
}

constexpr SolverKind kind_of_program(const char* name, AnsweredWith answered_with) {
  return {.name = name,
          .role = SolverRole::simulation,
          .answered_with = answered_with,
          .elements = "particles",
          .can_refer = false,
          .takes_outline = true,
          .declares_quantities = true};
}

// In the order of the variant's alternatives, of which OpenFOAM's has a kind for each FoamProgram.
constexpr SolverKind kinds[] = {
    {.name = "sph",
     .role = SolverRole::simulation,
     .elements = "particles",
     .solves_flow = true,
     .has_particles = true,
     .can_refer = false,
     .takes_outline = true},
    kind_of_foam("interfoam"),
    kind_of_foam("interisofoam"),
    kind_of_foam("compressible_interfoam"),
    {.name = "linear",
     .role = SolverRole::theory,
     .leaves = {finer, nonlinear},
     .takes_outline = true},
    {.name = "viscous_wave", .role = SolverRole::theory, .leaves = {nonlinear}},
    {.name = "potential", .role = SolverRole::theory, .can_end_early = true, .leaves = {coarser}},
    {.name = "record",
     .role = SolverRole::record,
     .can_end_early = true,
     .takes_outline = true,
     .declares_quantities = true},
    kind_of_program("external", AnsweredWith::user_program),
    kind_of_program("stored", AnsweredWith::stored_files)};
constexpr std::size_t programs = std::size(foam_program_names);
static_assert(std::size(kinds) ==
              std::variant_size_v<decltype(RunDefinition::solver)> + programs - 1);

// A run of an external program or a stored result of one.
template <class Run>
concept OfMethod = requires(const Run& run) {
  run.method;
};

std::optional<double> spacing(const auto&) { return {}; }
std::optional<double> spacing(const SphRun& sph) { return sph.particle_spacing; }
std::optional<double> spacing(const ExternalRun& external) { return external.particle_spacing; }
std::optional<double> spacing(const StoredRun& stored) {
  return stored.particle_spacing > 0 ? std::optional(stored.particle_spacing) : std::nullopt;
}

double resolution_of(const auto& run) { return spacing(run) ? std::pow(*spacing(run), -2) : 0; }
double resolution_of(const SphRun& sph) {
  return 1 / (sph.particle_spacing * sph.surface_particle_spacing);
}
double resolution_of(const InterFoamRun& mesh) { return 1.0 * mesh.cells_x * mesh.cells_z; }

std::string program(const InterFoamRun& mesh) { return name_of(mesh.program, foam_program_names); }

// Empty for a run that is a family by itself.
std::string family_of(const auto&) { return ""; }
std::string family_of(const SphRun& sph) { return sph.scheme; }
std::string family_of(const InterFoamRun& mesh) { return program(mesh); }
std::string family_of(const OfMethod auto& run) { return run.method; }

std::string changes(const auto&) { return ""; }
std::string changes(const SphRun& sph) { return changes_of(sph); }
std::string changes(const InterFoamRun& mesh) {
  std::vector<std::string> changes;
  if (mesh.courant_number != InterFoamRun().courant_number)
    changes.push_back(fmt::format("courant_number = {:g}", mesh.courant_number));
  if (mesh.interface_courant_number != mesh.courant_number)
    changes.push_back(
        fmt::format("interface_courant_number = {:g}", mesh.interface_courant_number));
  if (mesh.outer_corrections != InterFoamRun().outer_corrections)
    changes.push_back(fmt::format("outer_corrections = {}", mesh.outer_corrections));
  if (mesh.no_slip) changes.push_back("no_slip");
  if (mesh.wall_cell) changes.push_back("graded cells");
  if (mesh.cells_y) changes.push_back("three dimensions");
  return fmt::format("{}", fmt::join(changes, ", "));
}

std::string text_of(const SphRun& sph) {
  const std::string changes = changes_of(sph);
  std::string text =
      fmt::format("SPH `{}`{}, spacing {:.4g} mm", sph.scheme,
                  changes.empty() ? "" : " with " + changes, 1000 * sph.particle_spacing);
  if (sph.surface_particle_spacing != sph.particle_spacing)
    text += fmt::format(", {:.4g} mm at the surface", 1000 * sph.surface_particle_spacing);
  return text;
}
std::string caption_of(const SphRun& sph) {
  const double inside = 1000 * sph.particle_spacing, surface = 1000 * sph.surface_particle_spacing;
  std::string text = fmt::format("SPH, scheme {}, {:.4g} mm", sph.scheme, inside);
  if (surface != inside) text += fmt::format(" and {:.4g} mm at the surface", surface);
  if (const std::string changes = changes_of(sph); !changes.empty()) text += ", " + changes;
  return text;
}
json hashed(const SphRun& sph) {
  json numbers = json::object();
  for (const auto& [name, number] : sph_number_names)
    numbers[name] = sph.numbers.*number ? json(*(sph.numbers.*number)) : json(nullptr);
  json settings = {{"sph",
                    {sph.scheme, sph.particle_spacing, sph.surface_particle_spacing, sph.variant,
                     sph.initial_state, numbers}}};
  if (sph.energy_budget) settings["energy_budget"] = true;
  if (sph.speed_from_coarse_run) settings["expected_speed"] = "coarse_run";
  if (sph.start_disorder > 0) settings["start"] = {sph.start_disorder, sph.start_seed};
  if (sph.start_rotation_deg != 0) settings["start_rotation_deg"] = sph.start_rotation_deg;
  return settings;
}

std::string caption_of(const InterFoamRun& mesh) {
  const std::string changed = changes(mesh);
  const std::string across = mesh.cells_y ? fmt::format("{} x ", *mesh.cells_y) : "";
  return fmt::format("{}, {} x {}{} cells{}{}", program(mesh), mesh.cells_x, across, mesh.cells_z,
                     changed.empty() ? "" : ", ", changed);
}
std::string text_of(const InterFoamRun& mesh) {
  return caption_of(mesh) +
         (mesh.processes > 1 ? fmt::format(", {} processes", mesh.processes) : "");
}
json hashed(const InterFoamRun& mesh) {
  json settings = {{"interfoam", {mesh.cells_x, mesh.cells_z, mesh.processes}}};
  if (mesh.program != FoamProgram::inter_foam) settings["program"] = program(mesh);
  if (const std::string changed = changes(mesh); !changed.empty())
    settings["changes"] = {mesh.courant_number, mesh.interface_courant_number,
                           mesh.outer_corrections, mesh.no_slip, mesh.wall_cell.value_or(0)};
  if (mesh.cells_y) settings["cells_y"] = *mesh.cells_y;
  if (mesh.start_disorder > 0) settings["start"] = {mesh.start_disorder, mesh.start_seed};
  return settings;
}

std::string modes(const LinearRun& linear) {
  return linear.modes > 0 ? fmt::format(", {} modes", linear.modes) : "";
}
std::string text_of(const LinearRun& linear) {
  return fmt::format("linear potential flow{}{}, up to an elevation of {:g} fill depths",
                     modes(linear), linear.two_layer ? ", two layers, liquid and gas" : "",
                     linear.valid_elevation_over_depth);
}
std::string caption_of(const LinearRun& linear) {
  return fmt::format("linear potential theory{}{}", modes(linear),
                     linear.two_layer ? ", with the gas" : "");
}
json hashed(const LinearRun& linear) { return {{"linear", {linear.modes, linear.two_layer}}}; }

std::string text_of(const ViscousWaveRun& wave) {
  return fmt::format("linear wave of a viscous liquid, up to an elevation of {:g} fill depths",
                     wave.valid_elevation_over_depth);
}
std::string caption_of(const ViscousWaveRun&) { return "linear theory of the viscous wave"; }
json hashed(const ViscousWaveRun&) { return "viscous_wave"; }

std::string caption_of(const PotentialRun& potential) {
  return fmt::format("nonlinear potential flow, {} x {} nodes", potential.nodes_x,
                     potential.nodes_z);
}
std::string text_of(const PotentialRun& potential) { return "fully " + caption_of(potential); }
json hashed(const PotentialRun& potential) {
  return {{"potential", {potential.nodes_x, potential.nodes_z}}};
}

std::string text_of(const RecordRun& record) {
  return fmt::format("{} of {}{}", record.earlier_run ? "earlier run's record" : "published record",
                     record.quantity, record.supplied ? "" : ", which you would have to supply");
}
std::string caption_of(const RecordRun& record) {
  return (record.earlier_run ? "earlier run's record " : "published record ") +
         record.file.filename().string();
}
json hashed(const RecordRun& record) {
  const json uncertainty = record.uncertainty ? json(*record.uncertainty) : json(nullptr);
  json hashed{{"record", {record.quantity, record.unit, record.time, record.value, uncertainty}}};
  if (record.has_band) hashed["band"] = {record.lower, record.upper};
  return hashed;
}

std::string what(const ExternalRun& external) {
  return "external program " + std::filesystem::path(external.command.front()).filename().string();
}
std::string what(const StoredRun&) { return "stored result"; }

// "stored result, method `pysph`, spacing 10 mm" with these marks around the method.
std::string marked_text(const OfMethod auto& run, const char* mark) {
  std::string text = what(run);
  if (!run.method.empty()) text += fmt::format(", method {0}{1}{0}", mark, run.method);
  if (spacing(run)) text += fmt::format(", spacing {:.4g} mm", 1000 * *spacing(run));
  return text;
}
std::string text_of(const OfMethod auto& run) { return marked_text(run, "`"); }
std::string caption_of(const OfMethod auto& run) { return marked_text(run, ""); }

json hashed_series(const std::vector<SeriesSource>& sources) {
  json series = json::array();
  for (const SeriesSource& one : sources) {
    series.push_back({one.quantity, one.file.string(), one.format, one.column, one.unit,
                      one.time_column, one.time_unit, one.scale, one.offset, one.first_is_zero});
    if (one.time_offset != 0) series.back().push_back(one.time_offset);
  }
  return series;
}

json hashed(const ExternalRun& external) {
  json settings = {{"external", {external.command, hashed_series(external.series)}}};
  if (external.particle_spacing) settings["particle_spacing"] = *external.particle_spacing;
  if (!external.facts.empty()) settings["facts"] = external.facts.string();
  if (!external.version_command.empty()) settings["version"] = external.version_command;
  if (!external.fail_on.empty()) settings["fail_on"] = external.fail_on;
  if (external.cores) settings["cores"] = *external.cores;
  return settings;
}
json hashed(const StoredRun& stored) {
  std::vector<SeriesSource> series = stored.series;  // whose contents the key hashes too
  for (SeriesSource& one : series) one.file = one.file.filename();
  return {{"stored", {hashed_series(series), stored.method, stored.particle_spacing}}};
}

}  // namespace

const SolverKind& solver_kind(const RunDefinition& run) {
  const std::size_t at = run.solver.index();
  if (const auto* mesh = std::get_if<InterFoamRun>(&run.solver))
    return kinds[at + static_cast<std::size_t>(mesh->program)];
  return kinds[at == 0 ? at : at + programs - 1];
}

const SolverKind* find_solver_kind(std::string_view name) {
  for (const SolverKind& kind : kinds)
    if (kind.name == name) return &kind;
  return nullptr;
}

std::set<std::string> solvers_answered_with(AnsweredWith what) {
  std::set<std::string> names;
  for (const SolverKind& kind : kinds)
    if (kind.answered_with == what) names.insert(kind.name);
  return names;
}

std::vector<std::string> solvers_that_take_outlines() {
  std::vector<std::string> names;
  for (const SolverKind& kind : kinds)
    if (kind.takes_outline) names.push_back(kind.name);
  return names;
}

bool sees_gas(const RunDefinition& run) {
  const auto* linear = std::get_if<LinearRun>(&run.solver);
  return std::holds_alternative<InterFoamRun>(run.solver) || (linear && linear->two_layer);
}

std::string solver_text(const RunDefinition& run) {
  return std::visit([](const auto& solver) { return text_of(solver); }, run.solver);
}

std::string caption_text(const RunDefinition& run) {
  return std::visit([](const auto& solver) { return caption_of(solver); }, run.solver);
}

json hashed_settings(const RunDefinition& run) {
  return std::visit([](const auto& solver) { return hashed(solver); }, run.solver);
}

std::string family(const RunDefinition& run) {
  const auto named = std::visit([](const auto& solver) { return family_of(solver); }, run.solver);
  return named.empty() ? run.name : named;
}

std::optional<double> particle_spacing(const RunDefinition& run) {
  return std::visit([](const auto& solver) { return spacing(solver); }, run.solver);
}

std::string method_of(const RunDefinition& run) {
  const auto* external = std::get_if<ExternalRun>(&run.solver);
  const auto* stored = std::get_if<StoredRun>(&run.solver);
  return external ? external->method : stored ? stored->method : "";
}

double resolution(const RunDefinition& run) {
  return std::visit([](const auto& solver) { return resolution_of(solver); }, run.solver);
}

std::string changes_of(const SphRun& run) {
  std::vector<std::string> changes;
  if (!run.variant.empty()) changes.push_back(run.variant);
  if (!run.initial_state.empty()) changes.push_back("initial_state = " + run.initial_state);
  for (const auto& [name, number] : sph_number_names)
    if (const auto& value = run.numbers.*number)
      changes.push_back(fmt::format("{} = {:g}", name, *value));
  if (run.speed_from_coarse_run) changes.push_back("expected_speed = coarse_run");
  // The seed is no change: the repeats of a run have the same changes.
  if (run.start_disorder > unseen_disorder)
    changes.push_back(fmt::format("start_disorder = {:g}", run.start_disorder));
  if (run.start_rotation_deg != 0)
    changes.push_back(fmt::format("start_rotation_deg = {:g}", run.start_rotation_deg));
  return fmt::format("{}", fmt::join(changes, ", "));
}

std::string changes_of(const RunDefinition& run) {
  return std::visit([](const auto& solver) { return changes(solver); }, run.solver);
}

bool counts_from_its_first_value(const CaseDefinition& definition, const std::string& run,
                                 const std::string& quantity) {
  const auto counts_so = [&](const auto& solver) {
    if constexpr (requires { solver.series; })
      return std::any_of(solver.series.begin(), solver.series.end(), [&](const SeriesSource& one) {
        return one.quantity == quantity && one.first_is_zero;
      });
    return false;
  };
  return std::any_of(definition.runs.begin(), definition.runs.end(), [&](const auto& one) {
    return one.name == run && std::visit(counts_so, one.solver);
  });
}

bool is_changed(const RunDefinition& run) { return !changes_of(run).empty(); }

std::string work_family(const RunDefinition& run) {
  return is_changed(run) ? family(run) + ", " + changes_of(run) : family(run);
}

}  // namespace slosh
