#include "verification/peers/interfoam_tank.hpp"

#include <optional>
#include <stdexcept>

#include "openfoam_cases/geometry/initial_liquid.hpp"
#include "verification/case/field_times.hpp"
#include "verification/case/gap_friction.hpp"
#include "verification/case/motion.hpp"

namespace slosh {
namespace {

openfoam::PressureGauge::Wall wall_of(Wall wall) {
  using Of = openfoam::PressureGauge::Wall;
  switch (wall) {
    case Wall::left:
      return Of::left;
    case Wall::right:
      return Of::right;
    case Wall::bottom:
      return Of::bottom;
    case Wall::roof:
      break;
  }
  return Of::roof;
}

openfoam::Program program_of(FoamProgram program) {
  using Of = openfoam::Program;
  switch (program) {
    case FoamProgram::inter_iso_foam:
      return Of::inter_iso_foam;
    case FoamProgram::compressible_inter_foam:
      return Of::compressible_inter_foam;
    case FoamProgram::inter_foam:
      break;
  }
  return Of::inter_foam;
}

openfoam::PressureGauge sensor_of(const PressureGaugeDefinition& gauge) {
  openfoam::PressureGauge sensor{gauge.name, wall_of(gauge.wall), gauge.position, gauge.width};
  if (gauge.at) sensor.at = openfoam::Corner{gauge.at->x, gauge.at->z};
  return sensor;
}

}  // namespace

openfoam::SloshingTank interfoam_tank(const InterFoamRun& run, const CaseDefinition& definition) {
  const SurgeMotion motion = surge_motion(definition);
  openfoam::SloshingTank tank{
      .length = definition.tank.length,
      .height = definition.tank.height,
      .fill_depth = definition.liquid.fill_depth,
      .column_width = definition.liquid.column_width,
      .obstacles = {},
      .gravity = definition.gravity,
      .liquid = {definition.liquid.density, definition.liquid.kinematic_viscosity},
      .gas = {definition.gas.density, definition.gas.kinematic_viscosity},
      .gap_friction = run.cells_y ? 0 : gap_friction(definition),
      .velocity = motion.velocity,
      .acceleration = motion.acceleration,
      .initial_relative_velocity = definition.start == Start::earth ? -motion.velocity(0) : 0,
      .duration = definition.duration,
      .sample_interval = definition.sample_interval,
      .gauges = {},
      .cells_x = run.cells_x,
      .cells_z = run.cells_z,
      .processes = run.processes,
      .courant_number = run.courant_number,
      .interface_courant_number = run.interface_courant_number,
      .outer_corrections = run.outer_corrections,
      .no_slip = run.no_slip,
      .wall_cell = run.wall_cell,
      .program = program_of(run.program)};
  for (const Corner& corner : definition.tank.outline) tank.outline.push_back({corner.x, corner.z});
  if (run.cells_y) tank.gap = openfoam::Gap{definition.tank.breadth.value(), *run.cells_y};
  if (const auto& wave = definition.initial_wave)
    tank.initial_wave = openfoam::InitialWave{wave->mode, wave->amplitude};
  if (run.start_disorder > 0)
    tank.start_disturbance =
        openfoam::start_disturbance(run.start_disorder * definition.tank.height / run.cells_z,
                                    static_cast<unsigned>(run.start_seed));
  if (const std::optional<RollMotion> roll = roll_motion(definition))
    tank.roll = openfoam::Roll{
        roll->angle,  roll->rate,   roll->acceleration,
        roll->axis_x, roll->axis_z, definition.start == Start::earth ? -roll->rate(0) : 0};
  for (const GaugeDefinition& gauge : definition.gauges)
    tank.gauges.push_back({gauge.name, gauge.x});
  for (const PressureGaugeDefinition& gauge : definition.pressure_gauges)
    tank.pressure_gauges.push_back(sensor_of(gauge));
  for (const ProbeDefinition& probe : definition.probes)
    tank.probes.push_back({probe.name, probe.x, probe.z});
  for (const Wall wall : definition.wall_forces)
    tank.loaded_walls.push_back(name_of(wall, wall_names));
  tank.snapshot_times = field_times(definition);
  for (const ObstacleDefinition& one : definition.obstacles)
    tank.obstacles.push_back({one.left, one.right, one.bottom, one.top});
  return tank;
}

}  // namespace slosh
