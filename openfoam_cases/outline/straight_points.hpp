// Joins faces that lie in one line: those between the same two cells, and those of one cell on one
// edge of the outline. Merging cells leaves such faces. A short one beside a large cell is skewed.
#pragma once

#include <vector>

#include "openfoam_cases/outline/clipped_cells.hpp"

namespace slosh::openfoam {

// Drops the points between such faces from the cells' corners and from the outline, and numbers the
// points that are left anew, so that each has a use.
void drop_straight_points(std::vector<std::vector<int>>& cells, std::vector<OutlineStep>& outline,
                          std::vector<Corner>& points);

}  // namespace slosh::openfoam
