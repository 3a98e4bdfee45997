#pragma once

#include <vector>

#include "openfoam_cases/outline/clipped_cells.hpp"

namespace slosh::openfoam {

// Returns groups of pieces, as their indices with the largest piece first. A group with less than
// `least_area` [m2] joins the group with which it shares the longest face, the smallest group
// first. A group without a neighbour stays as small as it is.
std::vector<std::vector<int>> merge_pieces(const ClippedCells& clipped, double least_area);

// Returns the places of corners.
Polygon places_of(const std::vector<int>& corners, const std::vector<Corner>& points);

}  // namespace slosh::openfoam
