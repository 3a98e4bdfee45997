// Where the faces of the cells are along one side of the tank. The cells are uniform, or graded: of
// a given thickness w beside both ends of the side, from there each thicker than the one before by
// the ratio r, and uniform in the middle:
//
//     w, w r, ..., w r^(n-1), then uniform cells of w r^n, and back again.
//
// n is the smallest number with which r is at most 1.2, and r follows from the side's length.
#pragma once

#include <vector>

namespace slosh::openfoam {

class CellFaces {
 public:
  // Uniform cells on a side of this length [m].
  CellFaces(double length, int cells);
  // Graded cells. Throws std::invalid_argument with the key wall_cell for cells beside the walls
  // that are thicker than uniform ones, or so thin that r would exceed 1.2. `key` is that of the
  // number of cells.
  CellFaces(double length, int cells, double wall_cell, const char* key);

  int cells() const { return cells_; }
  double length() const { return length_; }
  bool is_graded() const { return !faces_.empty(); }
  double face(int index) const;    // [m] from the side's first end, of a cell's nearer face
  double centre(int index) const;  // [m]
  double size(int index) const;    // [m]
  double smallest() const;         // [m], of a cell

  // Returns a place's distance from the first end in cells: the index of its cell and the share of
  // that which lies before it. Places beyond the ends belong to the outermost cells.
  double cells_to(double place) const;
  // The same of uniform cells, rounded as the level and the gauges of all earlier cases were.
  double cells_over(double place) const;
  // Returns a place's distance from the first centre in distances of neighbouring centres, and its
  // inverse.
  double centres_to(double place) const;
  double at_centres(double distance) const;

  // The numbers of cells and the expansion ratios (last over first cell) of the part at an end, and
  // its length [m]; without cells where the cells are uniform.
  struct Part {
    int cells;
    double length, ratio;
  };
  Part graded_part() const;

 private:
  double length_;
  int cells_;
  int graded_cells_ = 0;       // n
  double ratio_ = 1;           // r
  std::vector<double> faces_;  // of graded cells, both ends included
};

}  // namespace slosh::openfoam
