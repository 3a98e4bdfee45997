// Reads the fields that a run wrote at a snapshot's time.
#pragma once

#include <filesystem>
#include <vector>

#include "openfoam_cases/geometry/tank_mesh.hpp"

namespace slosh::openfoam {

// Each field has one value per cell, in the same order; the obstacles' cells are left out. In a
// tank with an outline the cells beside it are cut or merged: they have the centroid and the area
// of what they are, 1/3 to 4/3 of a whole cell, rarely more. Of graded cells the fields are means
// over as many uniform cells (uniform_cells.hpp). In three dimensions they are those of the layer
// in the middle of the gap.
struct FieldSnapshot {
  double time;                     // [s]
  double cell_width, cell_height;  // of a whole cell [m]
  std::vector<double> x, z;        // of the cells' centres from the tank's bottom left corner [m]
  std::vector<double> area;        // of the cells [m2]
  std::vector<double> velocity_x, velocity_z;  // relative to the tank, along its axes [m/s]
  std::vector<double> pressure;                // less the gas's mean pressure [Pa]
  std::vector<double> liquid_share;            // volume fraction, 0 to 1
};

// Reads the time directory nearest to `time` [s]. The solver hits that time to a fraction of a time
// step, or less closely where samples are due shortly before or after it. Throws RunError where the
// difference exceeds the largest time step, and for a field that is missing, has another number of
// cells or is not finite.
FieldSnapshot read_snapshot(const SloshingTank& tank, const TankMesh& mesh,
                            const std::filesystem::path& case_directory, double time);

}  // namespace slosh::openfoam
