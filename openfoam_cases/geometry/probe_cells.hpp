// Which cells a probe reads, and with which weights: the value is bilinear between the centres of
// four cells, and extrapolated by at most half a cell beside a wall. A linear field is thus read
// without error. Beside an obstacle the cells that it fills count for nothing, and the weights of
// the others are raised to the sum of one. Beside an outline, where not all four cells are whole,
// the value is that of a plane through the cells around the probe's own, by least squares with the
// weights 1 / distance^2: a linear field is read without error there too.
#pragma once

#include <vector>

#include "openfoam_cases/geometry/tank_mesh.hpp"

namespace slosh::openfoam {

struct CellShare {
  Cell cell;
  double weight;  // the weights of a probe's cells sum to 1
};

// Throws std::invalid_argument for a place [m from the tank's bottom left corner] outside the tank
// or its outline, or in an obstacle.
std::vector<CellShare> cell_shares(const TankMesh& mesh, double x, double z);

}  // namespace slosh::openfoam
