#include <optional>

#include "sph/simulation.hpp"
#include "verification/case_file/motion.hpp"
#include "verification/runs/snapshots.hpp"
#include "verification/runs/solver_runs.hpp"

namespace slosh {
namespace {

std::optional<sph::InitialState> initial_state(const SphRun& sph) {
  if (sph.initial_state.empty()) return {};
  if (sph.initial_state == "lattice") return sph::InitialState::lattice;
  return sph.initial_state == "settled" ? sph::InitialState::settled : sph::InitialState::projected;
}

sph::Scene scene_of(const SphRun& sph, const CaseDefinition& definition) {
  const SurgeMotion motion = surge_motion(definition);
  const bool still_water = definition.motion.still() && !definition.liquid.column_width;
  sph::Scene scene{.tank_length = definition.tank.length,
                   .tank_height = definition.tank.height,
                   .fill_depth = definition.liquid.fill_depth,
                   .gravity = definition.gravity,
                   .rest_density = definition.liquid.density,
                   .kinematic_viscosity = definition.liquid.kinematic_viscosity,
                   .displacement = motion.displacement,
                   .velocity = motion.velocity,
                   .acceleration = motion.acceleration,
                   .initial_velocity = definition.start == Start::tank ? motion.velocity(0) : 0,
                   .duration = definition.duration,
                   .sample_interval = definition.sample_interval,
                   .particle_spacing = sph.particle_spacing,
                   .surface_particle_spacing = sph.surface_particle_spacing,
                   .column_width = definition.liquid.column_width,
                   .variant = sph.variant,
                   .numbers = {.smoothing_length_ratio = sph.numbers.smoothing_length_ratio,
                               .sound_speed_ratio = sph.numbers.sound_speed_ratio,
                               .courant_number = sph.numbers.courant_number,
                               .artificial_viscosity = sph.numbers.artificial_viscosity,
                               .density_diffusion = sph.numbers.density_diffusion},
                   .initial_state = initial_state(sph),
                   .gauges = {},
                   .record_still_water = still_water,
                   .record_snapshot = {}};
  for (const GaugeDefinition& gauge : definition.gauges)
    scene.gauges.push_back({gauge.name, gauge.x});
  for (const ObstacleDefinition& one : definition.obstacles)
    scene.obstacles.push_back({one.left, one.right, one.bottom, one.top});
  return scene;
}

TimeSeries series(const std::string& name, const std::string& unit, sph::History& history) {
  return {name, unit, std::move(history.time), std::move(history.value)};
}

}  // namespace

void require_scene(const SphRun& sph, const CaseDefinition& definition,
                   const RunDefinition& run) try {
  sph::Scene scene = scene_of(sph, definition);
  scene.duration = 0;  // lays the lattice and takes no step
  sph::run(sph.scheme, scene, {});
} catch (const std::invalid_argument& error) {
  throw refused(run, error.what());
}

RunResult run_sph(const SphRun& sph, const RunRequest& request) {
  sph::Scene scene = scene_of(sph, request.definition);
  std::optional<SnapshotWriter> snapshots;
  scene.snapshot_interval = request.settings.snapshot_interval;
  scene.record_snapshot = [&](const sph::Snapshot& snapshot) {
    if (!snapshots) snapshots.emplace(request.settings.work_directory, request.run.name);
    snapshots->record(snapshot);
  };
  sph::RunOutput output = sph::run(sph.scheme, scene, request.progress);

  RunResult result;
  for (const GaugeDefinition& gauge : request.definition.gauges) {
    result.series.push_back(
        series("elevation@" + gauge.name, "m", output.elevation.at(gauge.name)));
  }
  if (!output.front_position.time.empty())
    result.series.push_back(series("front_position", "m", output.front_position));
  result.series.push_back(series("horizontal_force", "N/m", output.horizontal_force));
  result.series.push_back(series("kinetic_energy", "J/m", output.kinetic_energy));
  result.series.push_back(series("potential_energy", "J/m", output.potential_energy));
  for (sph::RecordedSeries& one : output.still_water)
    result.series.push_back(series(one.name, one.unit, one.history));
  result.active_terms = std::move(output.active_terms);
  result.diagnostics = std::move(output.diagnostics);
  result.cost.steps = output.steps;
  result.cost.elements = static_cast<double>(output.particles);
  return result;
}

}  // namespace slosh
