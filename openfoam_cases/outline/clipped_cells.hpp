// The parts of uniform cells that lie inside an outline. The outline is first divided where it
// crosses the lines between cells, with the crossings exactly on these lines. After this no edge is
// cut again, and neighbouring cells share their corners bit for bit.
#pragma once

#include <utility>
#include <vector>

#include "openfoam_cases/geometry/cell.hpp"
#include "openfoam_cases/outline/outline.hpp"

namespace slosh::openfoam {

// The lines between uniform cells in a rectangle of this size [m].
struct UniformGrid {
  double length, height;
  int columns, rows;
  double face_x(int column) const { return length * (static_cast<double>(column) / columns); }
  double face_z(int row) const { return height * (static_cast<double>(row) / rows); }
};

// A part of a uniform cell inside the outline. The corners are indices of points,
// counter-clockwise, with every point that lies on its sides.
struct Piece {
  Cell place;
  std::vector<int> corners;
};

// A part of the outline that lies in one cell, from one point to another one.
struct OutlineStep {
  int begin, end;
  int edge;              // number of the outline's edge, which begins at the corner of this number
  double along, length;  // [m], distance of its begin from the outline's first corner, and length
};

struct ClippedCells {
  std::vector<Corner> points;  // not all of which have a use
  std::vector<Piece> pieces;
  std::vector<OutlineStep> outline;
};

// Places of the outline are moved onto a line between cells where they are closer to it than 1e-9
// of a cell. A cell that the outline divides has several pieces.
ClippedCells clip_cells(const Polygon& outline, const UniformGrid& grid);

// Returns the closed loops of these directed edges, of which opposite ones cancel. Throws
// std::invalid_argument, with the cell's place, where a loop passes a point twice.
std::vector<std::vector<int>> loops_of(const std::vector<std::pair<int, int>>& edges, Cell place);

// Throws std::invalid_argument, as the cell at this place is too large for the outline.
[[noreturn]] void refuse_cell(Cell place);

}  // namespace slosh::openfoam
