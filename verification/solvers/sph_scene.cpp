#include "verification/solvers/sph_scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "sph/simulation.hpp"
#include "verification/case/changed_input.hpp"
#include "verification/case/motion.hpp"

namespace slosh {
namespace {

std::optional<sph::InitialState> initial_state(const SphRun& sph) {
  if (sph.initial_state.empty()) return {};
  if (sph.initial_state == "lattice") return sph::InitialState::lattice;
  return sph.initial_state == "settled" ? sph::InitialState::settled : sph::InitialState::projected;
}

std::optional<sph::Roll> roll_of(const CaseDefinition& definition) {
  const std::optional<RollMotion> roll = roll_motion(definition);
  if (!roll) return {};
  return sph::Roll{roll->angle, roll->rate, roll->acceleration, roll->axis_x, roll->axis_z};
}

sph::Wall wall_of(Wall wall) {
  switch (wall) {
    case Wall::left:
      return sph::Wall::left;
    case Wall::right:
      return sph::Wall::right;
    case Wall::bottom:
      return sph::Wall::bottom;
    case Wall::roof:
      break;
  }
  return sph::Wall::roof;
}

sph::PressureGauge sensor_of(const PressureGaugeDefinition& gauge) {
  sph::PressureGauge sensor{gauge.name, wall_of(gauge.wall), gauge.position, gauge.width};
  if (gauge.at) sensor.at = sph::Corner{gauge.at->x, gauge.at->z};
  return sensor;
}

}  // namespace

// A number of the scheme that the case's runs can change needs a row in SphNumbers, its list of
// names, and the copy below.
static_assert(sizeof(SphNumbers) == sizeof(sph::SchemeNumbers));

sph::Scene sph_scene(const CaseDefinition& definition, const SphRun& sph) {
  const SurgeMotion motion = surge_motion(definition);
  const bool still_water =
      definition.motion.still() && !definition.liquid.column_width && !definition.initial_wave;
  sph::Scene scene{.tank_length = definition.tank.length,
                   .tank_height = definition.tank.height,
                   .fill_depth = definition.liquid.fill_depth,
                   .gravity = definition.gravity,
                   .rest_density = definition.liquid.density,
                   .kinematic_viscosity = definition.liquid.kinematic_viscosity,
                   .breadth = definition.tank.breadth.value_or(0),
                   .displacement = motion.displacement,
                   .velocity = motion.velocity,
                   .acceleration = motion.acceleration,
                   .roll = roll_of(definition),
                   .start = definition.start == Start::tank ? sph::Start::tank : sph::Start::earth,
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
                   .speed_from_coarse_run = sph.speed_from_coarse_run,
                   .initial_state = initial_state(sph),
                   .start_disorder = sph.start_disorder,
                   .start_seed = static_cast<unsigned>(sph.start_seed),
                   .start_rotation = sph.start_rotation_deg * std::numbers::pi / 180,
                   .gauges = {},
                   .record_still_water = still_water,
                   .record_energy_budget = sph.energy_budget,
                   .record_snapshot = {}};
  for (const Corner& corner : definition.tank.outline)
    scene.outline.push_back({corner.x, corner.z});
  if (const auto& wave = definition.initial_wave)
    scene.initial_wave = sph::InitialWave{wave->mode, wave->amplitude};
  for (const GaugeDefinition& gauge : definition.gauges)
    scene.gauges.push_back({gauge.name, gauge.x});
  for (const PressureGaugeDefinition& gauge : definition.pressure_gauges)
    scene.pressure_gauges.push_back(sensor_of(gauge));
  for (const ProbeDefinition& probe : definition.probes)
    scene.probes.push_back({probe.name, probe.x, probe.z});
  for (const Wall wall : definition.wall_forces)
    scene.loaded_walls.push_back({name_of(wall, wall_names), wall_of(wall)});
  for (const ObstacleDefinition& one : definition.obstacles)
    scene.obstacles.push_back({one.left, one.right, one.bottom, one.top});
  return scene;
}

}  // namespace slosh
