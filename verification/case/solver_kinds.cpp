#include "verification/case/solver_kinds.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

#include "verification/case/quantities.hpp"

namespace slosh {
namespace {

using nlohmann::json;

// What a row says unless it says otherwise.
struct CommonRow {
  static bool sees_gas(const auto&) { return false; }
  static std::string family(const RunDefinition& run) { return run.name; }
  static double resolution(const auto&) { return 0; }
  static std::optional<double> particle_spacing(const auto&) { return {}; }
  static std::string method_of(const auto&) { return ""; }
  static std::string changes(const auto&) { return ""; }
};

json hashed_series(const std::vector<SeriesSource>& sources) {
  json series = json::array();
  for (const SeriesSource& one : sources) {
    series.push_back({one.quantity, one.file.string(), one.format, one.column, one.unit,
                      one.time_column, one.time_unit, one.scale, one.offset, one.first_is_zero});
    if (one.time_offset != 0) series.back().push_back(one.time_offset);
  }
  return series;
}

// The row of a kind of solver; a kind without one does not compile.
template <class Run>
struct Row;

template <>
struct Row<SphRun> : CommonRow {
  static constexpr SolverKind kind{.name = "sph",
                                   .role = SolverRole::simulation,
                                   .elements = "particles",
                                   .solves_flow = true,
                                   .has_particles = true,
                                   .can_refer = false,
                                   .takes_outline = true};
  static std::string family(const RunDefinition& run) {
    return std::get<SphRun>(run.solver).scheme;
  }
  static double resolution(const SphRun& sph) {
    return 1 / (sph.particle_spacing * sph.surface_particle_spacing);
  }
  static std::optional<double> particle_spacing(const SphRun& sph) { return sph.particle_spacing; }
  static std::string changes(const SphRun& sph) { return changes_of(sph); }
  static std::string text(const SphRun& sph) {
    const std::string changes = changes_of(sph);
    std::string text =
        fmt::format("SPH `{}`{}, spacing {:.4g} mm", sph.scheme,
                    changes.empty() ? "" : " with " + changes, 1000 * sph.particle_spacing);
    if (sph.surface_particle_spacing != sph.particle_spacing)
      text += fmt::format(", {:.4g} mm at the surface", 1000 * sph.surface_particle_spacing);
    return text;
  }
  static std::string caption(const SphRun& sph) {
    const double inside = 1000 * sph.particle_spacing,
                 surface = 1000 * sph.surface_particle_spacing;
    std::string text = fmt::format("SPH, scheme {}, {:.4g} mm", sph.scheme, inside);
    if (surface != inside) text += fmt::format(" and {:.4g} mm at the surface", surface);
    if (const std::string changes = changes_of(sph); !changes.empty()) text += ", " + changes;
    return text;
  }
  static json hashed(const SphRun& sph) {
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
};

// What holds for every program of interFoam's family.
constexpr SolverKind foam_kind(const char* name) {
  return {.name = name,
          .role = SolverRole::simulation,
          .answered_with = AnsweredWith::openfoam,
          .build = "interfoam",
          .elements = "cells",
          .solves_flow = true,
          .takes_time_limit = true,
          .takes_outline = true};
}

template <>
struct Row<InterFoamRun> : CommonRow {
  // In the order of FoamProgram.
  static constexpr SolverKind kinds[] = {foam_kind("interfoam"), foam_kind("interisofoam"),
                                         foam_kind("compressible_interfoam")};
  static const SolverKind& kind_of(const InterFoamRun& mesh) {
    return kinds[static_cast<std::size_t>(mesh.program)];
  }
  static bool sees_gas(const InterFoamRun&) { return true; }
  static std::string program(const InterFoamRun& mesh) {
    return name_of(mesh.program, foam_program_names);
  }
  static std::string family(const RunDefinition& run) {
    return program(std::get<InterFoamRun>(run.solver));
  }
  static double resolution(const InterFoamRun& mesh) { return 1.0 * mesh.cells_x * mesh.cells_z; }
  static std::string text(const InterFoamRun& mesh) {
    return caption(mesh) +
           (mesh.processes > 1 ? fmt::format(", {} processes", mesh.processes) : "");
  }
  static std::string caption(const InterFoamRun& mesh) {
    const std::string changed = changes(mesh);
    const std::string across = mesh.cells_y ? fmt::format("{} x ", *mesh.cells_y) : "";
    return fmt::format("{}, {} x {}{} cells{}{}", program(mesh), mesh.cells_x, across, mesh.cells_z,
                       changed.empty() ? "" : ", ", changed);
  }
  static std::string changes(const InterFoamRun& mesh) {
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
  static json hashed(const InterFoamRun& mesh) {
    json settings = {{"interfoam", {mesh.cells_x, mesh.cells_z, mesh.processes}}};
    if (mesh.program != FoamProgram::inter_foam) settings["program"] = program(mesh);
    if (const std::string changed = changes(mesh); !changed.empty())
      settings["changes"] = {mesh.courant_number, mesh.interface_courant_number,
                             mesh.outer_corrections, mesh.no_slip, mesh.wall_cell.value_or(0)};
    if (mesh.cells_y) settings["cells_y"] = *mesh.cells_y;
    if (mesh.start_disorder > 0) settings["start"] = {mesh.start_disorder, mesh.start_seed};
    return settings;
  }
};

template <>
struct Row<LinearRun> : CommonRow {
  static constexpr SolverKind kind{.name = "linear",
                                   .role = SolverRole::theory,
                                   .leaves = {finer, nonlinear},
                                   .takes_outline = true};
  static bool sees_gas(const LinearRun& linear) { return linear.two_layer; }
  static std::string modes(const LinearRun& linear) {
    return linear.modes > 0 ? fmt::format(", {} modes", linear.modes) : "";
  }
  static std::string text(const LinearRun& linear) {
    return fmt::format("linear potential flow{}{}, up to an elevation of {:g} fill depths",
                       modes(linear), linear.two_layer ? ", two layers, liquid and gas" : "",
                       linear.valid_elevation_over_depth);
  }
  static std::string caption(const LinearRun& linear) {
    return fmt::format("linear potential theory{}{}", modes(linear),
                       linear.two_layer ? ", with the gas" : "");
  }
  static json hashed(const LinearRun& linear) {
    return {{"linear", {linear.modes, linear.two_layer}}};
  }
};

template <>
struct Row<ViscousWaveRun> : CommonRow {
  static constexpr SolverKind kind{
      .name = "viscous_wave", .role = SolverRole::theory, .leaves = {nonlinear}};
  static std::string text(const ViscousWaveRun& wave) {
    return fmt::format("linear wave of a viscous liquid, up to an elevation of {:g} fill depths",
                       wave.valid_elevation_over_depth);
  }
  static std::string caption(const ViscousWaveRun&) { return "linear theory of the viscous wave"; }
  static json hashed(const ViscousWaveRun&) { return "viscous_wave"; }
};

template <>
struct Row<PotentialRun> : CommonRow {
  static constexpr SolverKind kind{
      .name = "potential", .role = SolverRole::theory, .can_end_early = true, .leaves = {coarser}};
  static std::string text(const PotentialRun& potential) { return "fully " + caption(potential); }
  static std::string caption(const PotentialRun& potential) {
    return fmt::format("nonlinear potential flow, {} x {} nodes", potential.nodes_x,
                       potential.nodes_z);
  }
  static json hashed(const PotentialRun& potential) {
    return {{"potential", {potential.nodes_x, potential.nodes_z}}};
  }
};

template <>
struct Row<RecordRun> : CommonRow {
  static constexpr SolverKind kind{.name = "record",
                                   .role = SolverRole::record,
                                   .can_end_early = true,
                                   .takes_outline = true,
                                   .declares_quantities = true};
  static std::string text(const RecordRun& record) {
    return fmt::format("{} of {}{}",
                       record.earlier_run ? "earlier run's record" : "published record",
                       record.quantity, record.supplied ? "" : ", which you would have to supply");
  }
  static std::string caption(const RecordRun& record) {
    return (record.earlier_run ? "earlier run's record " : "published record ") +
           record.file.filename().string();
  }
  static json hashed(const RecordRun& record) {
    const json uncertainty = record.uncertainty ? json(*record.uncertainty) : json(nullptr);
    json hashed{{"record", {record.quantity, record.unit, record.time, record.value, uncertainty}}};
    if (record.has_band) hashed["band"] = {record.lower, record.upper};
    return hashed;
  }
};

template <>
struct Row<ExternalRun> : CommonRow {
  static constexpr SolverKind kind{.name = "external",
                                   .role = SolverRole::simulation,
                                   .answered_with = AnsweredWith::user_program,
                                   .elements = "particles",
                                   .can_refer = false,
                                   .takes_outline = true,
                                   .declares_quantities = true};
  static std::string family(const RunDefinition& run) {
    const std::string& method = std::get<ExternalRun>(run.solver).method;
    return method.empty() ? run.name : method;
  }
  static double resolution(const ExternalRun& external) {
    return external.particle_spacing ? std::pow(*external.particle_spacing, -2) : 0;
  }
  static std::optional<double> particle_spacing(const ExternalRun& external) {
    return external.particle_spacing;
  }
  static std::string method_of(const ExternalRun& external) { return external.method; }
  // ", method `pysph`, spacing 10 mm" with these marks around the method.
  static std::string method(const ExternalRun& external, const char* mark) {
    std::string text;
    if (!external.method.empty()) text += fmt::format(", method {0}{1}{0}", mark, external.method);
    if (external.particle_spacing)
      text += fmt::format(", spacing {:.4g} mm", 1000 * *external.particle_spacing);
    return text;
  }
  static std::string named(const ExternalRun& external, const char* mark) {
    return "external program " +
           std::filesystem::path(external.command.front()).filename().string() +
           method(external, mark);
  }
  static std::string text(const ExternalRun& external) { return named(external, "`"); }
  static std::string caption(const ExternalRun& external) { return named(external, ""); }
  static json hashed(const ExternalRun& external) {
    json settings = {{"external", {external.command, hashed_series(external.series)}}};
    if (external.particle_spacing) settings["particle_spacing"] = *external.particle_spacing;
    if (!external.facts.empty()) settings["facts"] = external.facts.string();
    if (!external.version_command.empty()) settings["version"] = external.version_command;
    if (!external.fail_on.empty()) settings["fail_on"] = external.fail_on;
    if (external.cores) settings["cores"] = *external.cores;
    return settings;
  }
};

template <>
struct Row<StoredRun> : CommonRow {
  static constexpr SolverKind kind{.name = "stored",
                                   .role = SolverRole::simulation,
                                   .answered_with = AnsweredWith::stored_files,
                                   .elements = "particles",
                                   .can_refer = false,
                                   .takes_outline = true,
                                   .declares_quantities = true};
  static std::string family(const RunDefinition& run) {
    const std::string& method = std::get<StoredRun>(run.solver).method;
    return method.empty() ? run.name : method;
  }
  static double resolution(const StoredRun& stored) {
    return stored.particle_spacing > 0 ? std::pow(stored.particle_spacing, -2) : 0;
  }
  static std::optional<double> particle_spacing(const StoredRun& stored) {
    return stored.particle_spacing > 0 ? std::optional(stored.particle_spacing) : std::nullopt;
  }
  static std::string method_of(const StoredRun& stored) { return stored.method; }
  static std::string named(const StoredRun& stored, const char* mark) {
    if (stored.method.empty()) return "stored result";
    return fmt::format("stored result, method {0}{1}{0}, spacing {2:.4g} mm", mark, stored.method,
                       1000 * stored.particle_spacing);
  }
  static std::string text(const StoredRun& stored) { return named(stored, "`"); }
  static std::string caption(const StoredRun& stored) { return named(stored, ""); }
  static json hashed(const StoredRun& stored) {
    std::vector<SeriesSource> series = stored.series;  // whose contents the key hashes too
    for (SeriesSource& one : series) one.file = one.file.filename();
    return {{"stored", {hashed_series(series), stored.method, stored.particle_spacing}}};
  }
};

template <class Run>
Row<Run> row_of(const Run&) {
  return {};
}

// The kinds of a row, of which OpenFOAM's has one for each program.
template <class Run>
std::span<const SolverKind> kinds_of_row() {
  if constexpr (requires { Row<Run>::kinds; })
    return Row<Run>::kinds;
  else
    return {&Row<Run>::kind, 1};
}

// All kinds, in the order of the variant's alternatives.
template <class... Runs>
std::vector<const SolverKind*> kinds_of(const std::variant<Runs...>*) {
  std::vector<const SolverKind*> all;
  for (const std::span<const SolverKind> row : {kinds_of_row<Runs>()...})
    for (const SolverKind& kind : row) all.push_back(&kind);
  return all;
}

const std::vector<const SolverKind*>& kinds() {
  static const auto all = kinds_of(static_cast<const decltype(RunDefinition::solver)*>(nullptr));
  return all;
}

}  // namespace

const SolverKind& solver_kind(const RunDefinition& run) {
  return std::visit(
      [](const auto& solver) -> const SolverKind& {
        using Of = decltype(row_of(solver));
        if constexpr (requires { Of::kind_of(solver); })
          return Of::kind_of(solver);
        else
          return Of::kind;
      },
      run.solver);
}

const SolverKind* find_solver_kind(std::string_view name) {
  for (const SolverKind* kind : kinds())
    if (kind->name == name) return kind;
  return nullptr;
}

std::set<std::string> solvers_answered_with(AnsweredWith what) {
  std::set<std::string> names;
  for (const SolverKind* kind : kinds())
    if (kind->answered_with == what) names.insert(kind->name);
  return names;
}

std::vector<std::string> solvers_that_take_outlines() {
  std::vector<std::string> names;
  for (const SolverKind* kind : kinds())
    if (kind->takes_outline) names.push_back(kind->name);
  return names;
}

bool sees_gas(const RunDefinition& run) {
  return std::visit([](const auto& solver) { return row_of(solver).sees_gas(solver); }, run.solver);
}

std::string solver_text(const RunDefinition& run) {
  return std::visit([](const auto& solver) { return row_of(solver).text(solver); }, run.solver);
}

std::string caption_text(const RunDefinition& run) {
  return std::visit([](const auto& solver) { return row_of(solver).caption(solver); }, run.solver);
}

json hashed_settings(const RunDefinition& run) {
  return std::visit([](const auto& solver) { return row_of(solver).hashed(solver); }, run.solver);
}

std::string family(const RunDefinition& run) {
  return std::visit([&](const auto& solver) { return row_of(solver).family(run); }, run.solver);
}

std::optional<double> particle_spacing(const RunDefinition& run) {
  return std::visit([](const auto& solver) { return row_of(solver).particle_spacing(solver); },
                    run.solver);
}

std::string method_of(const RunDefinition& run) {
  return std::visit([](const auto& solver) { return row_of(solver).method_of(solver); },
                    run.solver);
}

double resolution(const RunDefinition& run) {
  return std::visit([](const auto& solver) -> double { return row_of(solver).resolution(solver); },
                    run.solver);
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
  return std::visit([](const auto& solver) { return row_of(solver).changes(solver); }, run.solver);
}

bool is_changed(const RunDefinition& run) { return !changes_of(run).empty(); }

std::string work_family(const RunDefinition& run) {
  return is_changed(run) ? family(run) + ", " + changes_of(run) : family(run);
}

}  // namespace slosh
