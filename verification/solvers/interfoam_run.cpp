#include <fmt/format.h>

#include <stdexcept>

#include "openfoam_cases/check_tank.hpp"
#include "openfoam_cases/output/harvest.hpp"
#include "openfoam_cases/run_case.hpp"
#include "openfoam_cases/write_case.hpp"
#include "verification/peers/interfoam_tank.hpp"
#include "verification/results/taken_series.hpp"
#include "verification/solvers/solver_runs.hpp"

namespace slosh {
namespace {

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
  openfoam::check_tank(interfoam_tank(interfoam, definition));
} catch (const std::invalid_argument& error) {
  throw refused(run, error.what());
}

RunResult run_solver(const InterFoamRun& interfoam, const RunRequest& request) {
  const openfoam::SloshingTank tank = interfoam_tank(interfoam, request.definition);
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
  const bool is_iso = interfoam.program == FoamProgram::inter_iso_foam;
  result.active_terms = {"volume of fluid, liquid and gas",
                         std::string("interface by ") + (is_iso ? "isoAdvector" : "MULES"),
                         "laminar viscosity", interfoam.no_slip ? "no-slip walls" : "slip walls",
                         "acceleration in the tank's frame"};
  if (interfoam.wall_cell) result.active_terms.push_back("cells graded towards the walls");
  if (interfoam.program == FoamProgram::compressible_inter_foam)
    result.active_terms.push_back("compressible liquid, and gas of constant temperature");
  if (tank.gap_friction > 0)
    result.active_terms.push_back("friction of the gap walls, as of a porous medium");
  if (tank.gap)
    result.active_terms.push_back(
        fmt::format("three dimensions: half of a gap of {:.4g} mm in {} cells, sticking walls",
                    1e3 * tank.gap->breadth, tank.gap->cells));
  result.diagnostics = {{"max_courant_number", harvest.max_courant_number},
                        {"mean_pressure_iterations_per_step", harvest.mean_pressure_iterations},
                        {"relative_mass_loss", harvest.relative_mass_loss}};
  if (is_iso) result.diagnostics["faces_in_interface"] = harvest.faces_in_interface;
  result.provenance["openfoam_version"] = harvest.version;
  result.cost.steps = harvest.steps;
  result.cost.elements = harvest.cells;
  return result;
}

}  // namespace slosh
