// The highest place of a column of cells where the liquid's share is a half, linear between the
// cells' centres, and with the filling of the last cell under the roof or an obstacle: run-up and
// drops that the column's mean filling (gauge_columns.hpp) does not show. A level surface is found
// to 0.09 of a cell. A film thinner than half a cell is not seen.
#pragma once

#include <vector>

#include "openfoam_cases/geometry/tank_mesh.hpp"

namespace slosh::openfoam {

// The nearest column of each of the tank's gauges, ascending, each once.
std::vector<int> probed_columns(const SloshingTank& tank, const TankMesh& mesh);

// The column's free cells, from the bottom.
std::vector<int> free_rows(const TankMesh& mesh, int column);

// [m] above the bottom; the floor of the lowest free cell where no cell is half full. `fractions`:
// the liquid's share of each of free_rows().
double highest_surface(const TankMesh& mesh, int column, const std::vector<double>& fractions);

}  // namespace slosh::openfoam
