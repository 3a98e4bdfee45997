#include <optional>
#include <stdexcept>

#include "openfoam_cases/check_tank.hpp"
#include "openfoam_cases/geometry/initial_liquid.hpp"
#include "openfoam_cases/output/harvest.hpp"
#include "openfoam_cases/run_case.hpp"
#include "openfoam_cases/sloshing_tank.hpp"
#include "openfoam_cases/write_case.hpp"
#include "verification/case/field_times.hpp"
#include "verification/case/gap_friction.hpp"
#include "verification/case/motion.hpp"
#include "verification/results/taken_series.hpp"
#include "verification/solvers/solver_runs.hpp"

namespace slosh {
namespace {

openfoam::PressureGauge::Wall wall_of(Wall wall) {
  using Of = openfoam::PressureGauge::Wall;
  if (wall == Wall::bottom) return Of::bottom;
  return wall == Wall::left ? Of::left : Of::right;
}

openfoam::SloshingTank tank_of(const InterFoamRun& run, const CaseDefinition& definition) {
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
      .gap_friction = gap_friction(definition),
      .velocity = motion.velocity,
      .acceleration = motion.acceleration,
      .initial_relative_velocity = definition.start == Start::earth ? -motion.velocity(0) : 0,
      .duration = definition.duration,
      .sample_interval = definition.sample_interval,
      .gauges = {},
      .cells_x = run.cells_x,
      .cells_z = run.cells_z,
      .processes = run.processes};
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
    tank.pressure_gauges.push_back({gauge.name, wall_of(gauge.wall), gauge.position, gauge.width});
  for (const ProbeDefinition& probe : definition.probes)
    tank.probes.push_back({probe.name, probe.x, probe.z});
  for (const Wall wall : definition.wall_forces)
    tank.loaded_walls.push_back(name_of(wall, wall_names));
  tank.snapshot_times = field_times(definition);
  for (const ObstacleDefinition& one : definition.obstacles)
    tank.obstacles.push_back({one.left, one.right, one.bottom, one.top});
  return tank;
}

// Returns the cells that are at least half liquid.
FieldSnapshot liquid_of(const openfoam::FieldSnapshot& cells) {
  FieldSnapshot liquid{cells.time, cells.cell_width, cells.cell_height, {}, {}, {}, {}, {}};
  for (std::size_t i = 0; i < cells.x.size(); ++i) {
    if (!(cells.liquid_share[i] >= 0.5)) continue;
    liquid.x.push_back(cells.x[i]);
    liquid.z.push_back(cells.z[i]);
    liquid.velocity_x.push_back(cells.velocity_x[i]);
    liquid.velocity_z.push_back(cells.velocity_z[i]);
    liquid.pressure.push_back(cells.pressure[i]);
  }
  return liquid;
}

}  // namespace

void require_scene(const InterFoamRun& interfoam, const CaseDefinition& definition,
                   const RunDefinition& run) try {
  openfoam::check_tank(tank_of(interfoam, definition));
} catch (const std::invalid_argument& error) {
  throw refused(run, error.what());
}

RunResult run_solver(const InterFoamRun& interfoam, const RunRequest& request) {
  const openfoam::SloshingTank tank = tank_of(interfoam, request.definition);
  const auto case_directory = request.settings.work_directory / (request.run.name + ".openfoam");
  std::filesystem::remove_all(case_directory);  // an earlier, broken run may have left files
  openfoam::write_case(tank, request.settings.openfoam_templates, case_directory);
  openfoam::TimeLimits limits;
  if (request.settings.time_limit > 0) limits.solver = request.settings.time_limit;
  openfoam::run_case(tank, case_directory, request.progress, limits);
  openfoam::Harvest harvest = openfoam::harvest(tank, case_directory);

  RunResult result;
  take_common_series(harvest, result);
  take_series("liquid_volume", "m2", harvest.liquid_volume, result);
  for (const openfoam::FieldSnapshot& snapshot : harvest.snapshots)
    result.snapshots.push_back(liquid_of(snapshot));
  result.active_terms = {"volume of fluid, liquid and gas", "laminar viscosity", "slip walls",
                         "acceleration in the tank's frame"};
  if (tank.gap_friction > 0)
    result.active_terms.push_back("friction of front and back wall, as of a porous medium");
  result.diagnostics = {{"max_courant_number", harvest.max_courant_number},
                        {"mean_pressure_iterations_per_step", harvest.mean_pressure_iterations},
                        {"relative_mass_loss", harvest.relative_mass_loss}};
  result.provenance["openfoam_version"] = harvest.version;
  result.cost.steps = harvest.steps;
  result.cost.elements = harvest.cells;
  return result;
}

}  // namespace slosh
