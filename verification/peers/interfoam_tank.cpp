#include "verification/peers/interfoam_tank.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "openfoam_cases/geometry/initial_liquid.hpp"
#include "openfoam_cases/time_step.hpp"
#include "verification/case/field_times.hpp"
#include "verification/case/gap_friction.hpp"
#include "verification/case/motion.hpp"
#include "verification/case/motion/motion_times.hpp"

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

// A motion by a table is read at rows of interFoam's own table, two time steps or more apart: what
// alternates from point to point, as the noise of a recorded motion does, then cancels in the
// solver, which reads its table once a step.
void set_motion(const CaseDefinition& definition, openfoam::SloshingTank& tank) {
  const double row = openfoam::motion_step(tank);
  const double apart = std::min(2 * openfoam::max_time_step(tank), tank.duration / 100);
  const CaseDefinition read = with_tables_at(definition, row * std::ceil(apart / row));
  const bool set_off = definition.start == Start::earth;
  const SurgeMotion surge = surge_motion(read);
  tank.velocity = surge.velocity;
  tank.acceleration = surge.acceleration;
  tank.initial_relative_velocity = set_off ? -surge.velocity(0) : 0;
  if (const std::optional<RollMotion> roll = roll_motion(read))
    tank.roll = openfoam::Roll{roll->angle,  roll->rate,   roll->acceleration,
                               roll->axis_x, roll->axis_z, set_off ? -roll->rate(0) : 0};
}

}  // namespace

openfoam::SloshingTank interfoam_tank(const InterFoamRun& run, const CaseDefinition& definition) {
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
      .velocity = {},
      .acceleration = {},
      .initial_relative_velocity = 0,
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
  set_motion(definition, tank);
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
