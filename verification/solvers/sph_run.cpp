#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "sph/simulation.hpp"
#include "verification/case/field_times.hpp"
#include "verification/case/motion.hpp"
#include "verification/results/taken_series.hpp"
#include "verification/solvers/particles/state_file.hpp"
#include "verification/solvers/snapshots.hpp"
#include "verification/solvers/solver_runs.hpp"
#include "verification/solvers/sph_scene.hpp"

namespace slosh {
namespace {

// The times of snapshot files and of the result's snapshots, as whole numbers of samples. The
// solver hands over snapshots at equal intervals.
class SnapshotTimes {
 public:
  SnapshotTimes(const CaseDefinition& definition, double file_interval)
      : sample_interval_(definition.sample_interval),
        file_stride_(samples(file_interval)),
        stride_(file_stride_) {
    for (const double time : field_times(definition)) {
      result_.push_back(samples(time));
      stride_ = std::gcd(stride_, result_.back());
    }
  }
  double interval() const { return static_cast<double>(stride_) * sample_interval_; }
  bool for_file(double time) const { return file_stride_ && samples(time) % file_stride_ == 0; }
  bool for_result(double time) const {
    return std::find(result_.begin(), result_.end(), samples(time)) != result_.end();
  }

 private:
  long samples(double time) const { return std::lround(time / sample_interval_); }

  double sample_interval_;
  long file_stride_, stride_;
  std::vector<long> result_;
};

// Returns the snapshot with velocities relative to the tank, along its axes.
FieldSnapshot as_seen_in_the_tank(const sph::Snapshot& snapshot, const CaseDefinition& definition,
                                  double spacing) {
  const double surge = surge_motion(definition).velocity(snapshot.time);
  const std::optional<RollMotion> roll = roll_motion(definition);
  const double angle = roll ? roll->angle(snapshot.time) : 0,
               rate = roll ? roll->rate(snapshot.time) : 0;
  FieldSnapshot field{.time = snapshot.time,
                      .width = spacing,
                      .height = spacing,
                      .x = snapshot.x,
                      .z = snapshot.z,
                      .velocity_x = snapshot.velocity_x,
                      .velocity_z = snapshot.velocity_z,
                      .pressure = snapshot.pressure};
  for (std::size_t i = 0; i < field.x.size(); ++i) {
    field.velocity_x[i] -=
        surge * std::cos(angle) - (roll ? rate * (field.z[i] - roll->axis_z) : 0);
    field.velocity_z[i] -=
        -surge * std::sin(angle) + (roll ? rate * (field.x[i] - roll->axis_x) : 0);
  }
  return field;
}

// Runs the scene. Where the run fails its last good state stays on the disk, and the error names
// it.
sph::RunOutput run_scene(const std::string& scheme, sph::Scene& scene, const RunRequest& request) {
  const auto file = last_good_state_file(request.settings.work_directory, request.run.name);
  std::string left;
  scene.save_last_good_state = [&](const sph::SavedState& state) {
    const double time = state.numbers.at("time");
    try {
      write_state(state, request.settings.key, file);
      left = fmt::format("; the last good state, of t = {:.6g} s, is {}", time, file.string());
    } catch (const ResultError& error) {
      left = fmt::format("; the last good state could not be saved: {}", error.what());
    }
  };
  try {
    return sph::run(scheme, scene, request.progress);
  } catch (const sph::SimulationError& error) {
    throw SolverError(error.what() + left);
  }
}

}  // namespace

SphOutline sph_outline(const CaseDefinition& definition, const RunDefinition& run) try {
  const SphRun& sph = std::get<SphRun>(run.solver);
  sph::Scene scene = sph_scene(definition, sph);
  scene.takes_steps = false;
  sph::RunOutput start = sph::run(sph.scheme, scene, {});
  return {start.particles, std::move(start.active_terms),
          start.diagnostics.at("expected_speed_m_s")};
} catch (const std::invalid_argument& error) {
  throw refused(run, error.what());
}

void require_scene(const SphRun&, const CaseDefinition& definition, const RunDefinition& run) {
  sph_outline(definition, run);
}

RunResult run_solver(const SphRun& sph, const RunRequest& request) {
  const CaseDefinition& definition = request.definition;
  sph::Scene scene = sph_scene(definition, sph);
  const SnapshotTimes times(definition, request.settings.snapshot_interval);
  RunResult result;
  std::optional<SnapshotWriter> file;
  scene.snapshot_interval =
      field_times(definition).empty() ? request.settings.snapshot_interval : times.interval();
  scene.record_snapshot = [&](const sph::Snapshot& snapshot) {
    if (times.for_result(snapshot.time))
      result.snapshots.push_back(as_seen_in_the_tank(snapshot, definition, sph.particle_spacing));
    if (!times.for_file(snapshot.time)) return;
    if (!file) file.emplace(request.settings.work_directory, request.run.name);
    file->record(snapshot);
  };
  scene.state_interval = request.settings.state_interval;
  scene.save_state = [&](const sph::SavedState& state) {
    write_state(state, request.settings.key,
                state_file(request.settings.work_directory, request.run.name));
  };
  std::optional<sph::SavedState> resumed;
  if (!request.settings.resume.empty()) {
    resumed = read_state(request.settings.key, request.settings.resume);
    scene.resume = &*resumed;
  }
  sph::RunOutput output = run_scene(sph.scheme, scene, request);

  take_common_series(output, result);
  take_series("kinetic_energy", "J/m", output.kinetic_energy, result);
  take_series("potential_energy", "J/m", output.potential_energy, result);
  for (auto* list : {&output.still_water, &output.energy, &output.soundness})
    for (sph::RecordedSeries& one : *list) take_series(one.name, one.unit, one.history, result);
  take_series("packing_drift", "1", output.packing_drift, result);
  result.active_terms = std::move(output.active_terms);
  result.diagnostics = std::move(output.diagnostics);
  result.cost.steps = output.steps;
  result.cost.elements = static_cast<double>(output.particles);
  return result;
}

}  // namespace slosh
