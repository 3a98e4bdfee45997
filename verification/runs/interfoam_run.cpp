#include <stdexcept>

#include "openfoam_cases/check_tank.hpp"
#include "openfoam_cases/sloshing_tank.hpp"
#include "verification/case_file/motion.hpp"
#include "verification/runs/solver_runs.hpp"

namespace slosh {
namespace {

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
      .velocity = motion.velocity,
      .acceleration = motion.acceleration,
      .initial_relative_velocity = definition.start == Start::earth ? -motion.velocity(0) : 0,
      .duration = definition.duration,
      .sample_interval = definition.sample_interval,
      .gauges = {},
      .cells_x = run.cells_x,
      .cells_z = run.cells_z,
      .processes = run.processes};
  for (const GaugeDefinition& gauge : definition.gauges)
    tank.gauges.push_back({gauge.name, gauge.x});
  for (const ObstacleDefinition& one : definition.obstacles)
    tank.obstacles.push_back({one.left, one.right, one.bottom, one.top});
  return tank;
}

TimeSeries series(const std::string& name, const std::string& unit, openfoam::History& history) {
  return {name, unit, std::move(history.time), std::move(history.value)};
}

}  // namespace

void require_scene(const InterFoamRun& interfoam, const CaseDefinition& definition,
                   const RunDefinition& run) try {
  openfoam::check_tank(tank_of(interfoam, definition));
} catch (const std::invalid_argument& error) {
  throw refused(run, error.what());
}

RunResult run_interfoam(const InterFoamRun& interfoam, const RunRequest& request) {
  const openfoam::SloshingTank tank = tank_of(interfoam, request.definition);
  const auto case_directory = request.settings.work_directory / (request.run.name + ".openfoam");
  std::filesystem::remove_all(case_directory);  // what an earlier, broken run may have left
  openfoam::write_case(tank, request.settings.openfoam_templates, case_directory);
  openfoam::run_case(tank, case_directory, request.progress);
  openfoam::Harvest harvest = openfoam::harvest(tank, case_directory);

  RunResult result;
  for (const GaugeDefinition& gauge : request.definition.gauges) {
    result.series.push_back(
        series("elevation@" + gauge.name, "m", harvest.elevation.at(gauge.name)));
  }
  if (!harvest.front_position.time.empty())
    result.series.push_back(series("front_position", "m", harvest.front_position));
  result.series.push_back(series("horizontal_force", "N/m", harvest.force_x));
  result.series.push_back(series("liquid_volume", "m2", harvest.liquid_volume));
  result.active_terms = {"volume of fluid, liquid and gas", "laminar viscosity", "slip walls",
                         "acceleration in the tank's frame"};
  result.diagnostics = {{"max_courant_number", harvest.max_courant_number},
                        {"mean_pressure_iterations_per_step", harvest.mean_pressure_iterations},
                        {"relative_mass_loss", harvest.relative_mass_loss}};
  result.provenance["openfoam_version"] = harvest.version;
  result.cost.steps = harvest.steps;
  result.cost.elements = harvest.cells;
  return result;
}

}  // namespace slosh
