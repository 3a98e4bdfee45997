// The order in which the cells of a cut mesh are numbered. OpenFOAM 1912 compiled by GCC 12 (Debian
// 12) multiplies tensors by vectors in pairs of cells, where the result takes the place of the
// vectors: the second cell of a pair then takes the x component of the result for that of the
// vector. interFoam obtains each cell's velocity from its fluxes in this way (fvc::reconstruct).
// The error is zero where the tensor, the sum of S S / |S| over the cell's faces, has no component
// xz, as in every cell whose faces are parallel to the axes. In other cells the velocity grows
// without limit within a few dozen steps. They therefore get even numbers, counted from 0. With a
// correct OpenFOAM the order has no effect but round-off.
#pragma once

#include <vector>

#include "openfoam_cases/geometry/cell.hpp"

namespace slosh::openfoam {

struct CellToOrder {
  Cell place;
  bool is_oblique;  // it has a face that is not parallel to an axis
  int process = 0;  // set by order_cells()
};

// Returns the cells' indices in their order, and sets their processes: each process has columns
// next to each other with about the same number of cells, its cells follow one another, and in them
// no oblique cell has an odd number. Otherwise they are row by row from the bottom. Throws
// std::invalid_argument where a process has more oblique cells than others, or no cell.
std::vector<int> order_cells(std::vector<CellToOrder>& cells, int processes);

}  // namespace slosh::openfoam
