#include "verification/runs/run_case.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <stdexcept>
#include <vector>

#include "openfoam_cases/errors.hpp"
#include "sph/simulation.hpp"
#include "verification/case/changed_input.hpp"
#include "verification/case/ensemble.hpp"
#include "verification/case/metric_table.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/files/own_files.hpp"
#include "verification/input/nearest_name.hpp"
#include "verification/results/provenance.hpp"
#include "verification/runs/filtered_pressures.hpp"
#include "verification/runs/fitting_spacing.hpp"
#include "verification/solvers/solver_runs.hpp"

namespace slosh {
namespace {

constexpr const char* too_large =
    "it needs more memory than there is; expected fewer modes, particles, nodes or samples";

bool is_finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(),
                     [](double value) { return std::isfinite(value); });
}

// Throws SolverError where a series ends early or holds NaN or infinity, even if the solver reports
// success.
void require_whole(const TimeSeries& series, const CaseDefinition& definition) {
  if (series.time.empty() || series.time.size() != series.value.size()) {
    throw SolverError(fmt::format("the series {} has {} times and {} values", series.name,
                                  series.time.size(), series.value.size()));
  }
  const double missing = definition.duration - series.time.back();
  // The last sample may lie anywhere in the last interval.
  if (!(missing <= definition.sample_interval)) {
    throw SolverError(fmt::format("the series {} ends at {} s, expected {} s", series.name,
                                  series.time.back(), definition.duration));
  }
  if (!is_finite(series.time) || !is_finite(series.value)) {
    throw SolverError(fmt::format("the series {} holds NaN or infinite values", series.name));
  }
}

// What the solvers write beside the result. The user may have named the directory of the result by
// a link, but none below it.
std::vector<std::filesystem::path> places_of(const RunRequest& request) {
  const RunSettings& settings = request.settings;
  if (settings.work_directory.empty()) return {};
  const std::filesystem::path named = std::filesystem::absolute(settings.work_directory),
                              work = std::filesystem::weakly_canonical(named.parent_path()) /
                                     named.filename();
  const AnsweredWith kind = solver_kind(request.run).answered_with;
  std::vector<const char*> endings;
  if (kind == AnsweredWith::openfoam) endings = {".openfoam"};
  if (settings.snapshot_interval != 0 || settings.state_interval != 0)
    endings = {".snapshots.h5", ".snapshots.xmf", ".state.h5", ".last_good.h5"};
  std::vector<std::filesystem::path> places;
  std::error_code absent;
  for (const char* ending : endings)
    // A run that goes on from a state may save another one there.
    if (const auto place = work / (request.run.name + ending);
        settings.resume.empty() || !std::filesystem::equivalent(settings.resume, place, absent))
      places.push_back(place);
  return places;
}

// Runs the solver and turns the leaves' exceptions into those of execute().
RunResult run_chosen_solver(const RunRequest& request) try {
  const OpenOutputs places(places_of(request));
  RunResult result = run_solver(request);
  if (!solver_kind(request.run).can_end_early)
    for (const TimeSeries& series : result.series) require_whole(series, request.definition);
  return result;
} catch (const std::invalid_argument& error) {  // a case that the solver does not take
  throw refused(request.run,
                error.what() + spacing_hint(error.what(), request.definition, request.run));
} catch (const sph::SimulationError& error) {
  throw SolverError(error.what());
} catch (const std::bad_alloc&) {
  throw SolverError(request.run.name + ": " + too_large);
} catch (const std::length_error&) {
  throw SolverError(request.run.name + ": " + too_large);
} catch (const openfoam::RunError& error) {
  throw SolverError({"solver failed", error.message, error.words, error.log.string()});
} catch (const std::filesystem::filesystem_error& error) {
  throw SolverError(error.what());
}

const std::vector<std::string> sph_series{"kinetic_energy",
                                          "potential_energy",
                                          "internal_energy",
                                          "wall_work",
                                          "dissipated_energy",
                                          "energy_residual",
                                          "mach_number",
                                          "density_error",
                                          "tension_share",
                                          "packing_drift",
                                          "hydrostatic_pressure_error",
                                          "kinetic_over_potential_energy",
                                          "wall_gap",
                                          "volume_drift"};
const std::vector<std::string> interfoam_series{"liquid_volume"};

// The series that a run may leave. Which of them a theory has, and SPH of water at rest, is known
// after the run alone.
std::vector<std::string> possible_series(const CaseDefinition& definition,
                                         const RunDefinition& run) {
  std::vector<std::string> names;
  const auto add_declared = [&](const auto& solver) {
    if constexpr (requires { solver.series; })
      for (const SeriesSource& one : solver.series)
        names.insert(names.end(), {one.quantity, one.quantity + through_filter});
    if constexpr (requires { solver.quantity; })
      names.insert(names.end(), {solver.quantity, solver.quantity + through_filter});
  };
  std::visit(add_declared, run.solver);
  if (solver_kind(run).declares_quantities || is_record(run)) return names;
  names = compared_quantities(definition);
  const bool is_sph = std::holds_alternative<SphRun>(run.solver),
             is_mesh = std::holds_alternative<InterFoamRun>(run.solver);
  if (is_sph) names.insert(names.end(), sph_series.begin(), sph_series.end());
  if (is_mesh) names.insert(names.end(), interfoam_series.begin(), interfoam_series.end());
  return names;
}

}  // namespace

void require_series(const CaseDefinition& definition, const GateRow& row) {
  if (is_of_fields(row.metric)) return;
  for (const std::string& name : {row.candidate, row.reference}) {
    if (name.empty()) continue;
    const std::vector<std::string> names = possible_series(definition, run_named(definition, name));
    if (std::find(names.begin(), names.end(), row.quantity) == names.end())
      throw CaseFileError(
          fmt::format("{}:{}: quantity = \"{}\": expected one that the run {} has, of {}{}",
                      row.where.file, row.where.line, row.quantity, name, fmt::join(names, ", "),
                      nearest_text(row.quantity, names)));
  }
}

void require_runnable(const CaseDefinition& definition, const RunDefinition& run) {
  const CaseDefinition solved = definition_solved_by(run, definition);
  try {
    require_scene(solved, run);
  } catch (const CaseFileError& error) {
    throw CaseFileError(error.what() + spacing_hint(error.what(), solved, run));
  } catch (const sph::SimulationError& error) {  // the start alone leaves the scheme's range
    throw refused(run, std::string("the start fails: ") + error.what());
  } catch (const std::bad_alloc&) {
    throw refused(run, too_large);
  } catch (const std::length_error&) {
    throw refused(run, too_large);
  }
}

RunResult execute(const CaseDefinition& definition, const RunDefinition& run,
                  const RunSettings& settings, const Progress& progress) {
  const CostMeter meter;
  const bool particles = solver_kind(run).has_particles;
  if (settings.snapshot_interval != 0 && !particles)
    throw refused(run, "snapshots: expected a run of the solver sph, no other has particles");
  if ((settings.state_interval != 0 || !settings.resume.empty()) && !particles)
    throw refused(run,
                  "states and resume: expected a run of the solver sph, no other saves states");
  if (settings.time_limit != 0 && !solver_kind(run).takes_time_limit)
    throw refused(run, "time limit: expected a run of the solver interfoam");
  const CaseDefinition solved = definition_solved_by(run, definition);
  RunResult result = run_chosen_solver({solved, run, settings, progress});
  const RunCost own = result.cost;
  if (!is_stored(run)) {  // a stored result keeps the cost that it had on another machine
    result.cost = meter.cost();
    result.cost.wall_time -= own.wall_time;
    result.cost.user_time -= own.user_time;
    result.cost.system_time -= own.system_time;
    result.cost.steps = own.steps;
    result.cost.elements = own.elements;
  }
  raise_dry_gauges(definition, run, result);
  // What cannot be filtered is told where the result is judged.
  add_filtered_pressures(solved, result);
  result.case_name = definition.name;
  result.run_name = run.name;
  result.solver = solver_name(run);
  result.case_text = definition.text;
  result.key = settings.key;
  result.provenance.merge(provenance(settings.command));
  if (const std::string drawn = drawn_inputs_text(run, definition.motion); !drawn.empty())
    result.provenance["drawn_inputs"] = drawn;
  // What compiled Slosh has compiled no other code.
  if (is_stored(run) || solver_kind(run).answered_with == AnsweredWith::user_program)
    for (const char* of_slosh : {"compiler", "compiler_flags"}) result.provenance.erase(of_slosh);
  return result;
}

}  // namespace slosh
