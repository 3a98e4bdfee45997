// The front of a liquid that runs along the tank's bottom: the furthest x at which the lowest row
// of cells is half full, linear between the cells' centres, and with the filling of the last cell
// before a wall or an obstacle. A sharp upright front is found to 0.09 of a cell and moves without
// a jump. A tongue thinner than half a cell is not seen; drops that fall ahead of the front are
// taken for it.
#pragma once

#include <vector>

#include "openfoam_cases/geometry/tank_mesh.hpp"

namespace slosh::openfoam {

// The columns whose lowest cell is free, from the left.
std::vector<int> bottom_columns(const TankMesh& mesh);

// [m] from the left wall; 0 where no cell is half full. `fractions`: the liquid's share of the
// lowest cell of each of bottom_columns().
double front_position(const TankMesh& mesh, const std::vector<double>& fractions);

}  // namespace slosh::openfoam
