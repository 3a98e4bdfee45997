// Where the liquid ends along a line of cells: the front along the tank's bottom and the highest
// surface in a column. Both are the last place where the liquid's volume fraction is a half, linear
// between the cells' centres; where a wall or an obstacle follows the last half-full cell, its
// volume fraction gives the place. A sharp edge is located to 0.09 of a cell (0.13 where cells grow
// by a fifth) and moves without a jump. A layer or film thinner than half a cell is not detected.
#pragma once

#include <vector>

#include "openfoam_cases/geometry/tank_mesh.hpp"

namespace slosh::openfoam {

// Returns the columns whose lowest cell is free, from the left.
std::vector<int> bottom_columns(const TankMesh& mesh);

// Returns x [m] of the front from the left wall, 0 where no cell is half full. Drops that fall
// ahead of the front are taken for it. `fractions` holds the liquid's volume fraction in the lowest
// cell of each of bottom_columns().
double front_position(const TankMesh& mesh, const std::vector<double>& fractions);

// Returns the column nearest to each of the tank's gauges, ascending and without duplicates.
std::vector<int> probed_columns(const SloshingTank& tank, const TankMesh& mesh);

// Returns the rows of the column's free cells, from the bottom.
std::vector<int> free_rows(const TankMesh& mesh, int column);

// Returns the height [m] of the highest surface above the bottom. It follows run-up and drops,
// which the column's mean filling (gauge_columns.hpp) does not show. Where no cell is half full it
// is the floor of the lowest free cell. `fractions` holds the liquid's volume fraction in each of
// free_rows().
double highest_surface(const TankMesh& mesh, int column, const std::vector<double>& fractions);

}  // namespace slosh::openfoam
