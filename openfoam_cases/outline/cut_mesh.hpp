// The mesh of a tank whose section is a polygon: uniform cells that the outline cuts. A part that
// is smaller than a third of a whole cell is merged into the neighbour with which it shares the
// longest face, as the Courant number of so small a cell would set the time step. Every cell has
// the place of its largest part, so that it belongs to one column and one row.
#pragma once

#include <vector>

#include "openfoam_cases/outline/clipped_cells.hpp"
#include "openfoam_cases/outline/filling.hpp"

namespace slosh::openfoam {

struct CutCell {
  Cell place;
  std::vector<int> corners;  // indices of points, counter-clockwise
  Polygon polygon;           // the same as places [m]
  double area;               // [m2]
  Corner centroid;           // [m]
  Corner inside;             // [m], the centroid or, where that lies outside, another place
  bool is_whole;             // a uniform cell, neither cut nor merged
  int process;               // that computes it
};

// A face between two cells. Seen from begin to end the owner is on the left.
struct InnerFace {
  int begin, end;        // indices of points
  int owner, neighbour;  // indices of cells, owner < neighbour
};

struct WallFace {
  int begin, end;        // indices of points
  int owner;             // index of the cell
  int edge;              // of the outline
  double along, length;  // [m], as those of OutlineStep
};

class CutMesh {
 public:
  // Throws std::invalid_argument where the outline divides a cell into parts of which two are too
  // large to be merged or touch, where the cells are in rooms without a connection, and as
  // order_cells() does.
  CutMesh(const Polygon& outline, const UniformGrid& grid, int processes = 1);

  const Polygon& outline() const { return outline_; }
  const UniformGrid& grid() const { return grid_; }
  const std::vector<Corner>& points() const { return points_; }   // [m]
  const std::vector<CutCell>& cells() const { return cells_; }    // in the order of cell_order.hpp
  const std::vector<InnerFace>& faces() const { return faces_; }  // by owner, then by neighbour
  const std::vector<WallFace>& walls() const { return walls_; }   // along the outline
  double perimeter() const;                                       // [m]

  // Returns the index of the cell of this place, -1 where there is none.
  int index_at(Cell place) const;
  const CutCell& at(Cell place) const { return cells_[index_at(place)]; }
  // Returns the cells of a column, from the bottom.
  std::vector<int> column(int column) const;
  // Returns how the cells of a column fill.
  const Filling& filling(int column) const { return fillings_[column]; }

 private:
  void find_faces(const std::vector<OutlineStep>& outline);
  void check_rooms() const;

  Polygon outline_;
  UniformGrid grid_;
  std::vector<Corner> points_;
  std::vector<CutCell> cells_;
  std::vector<int> index_;  // by place, row by row
  std::vector<InnerFace> faces_;
  std::vector<WallFace> walls_;
  std::vector<Filling> fillings_;
};

}  // namespace slosh::openfoam
