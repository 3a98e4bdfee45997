// The uniform mesh of the tank without the cells that its obstacles fill: which cells there are,
// the blocks that blockMesh builds them of, and the order in which OpenFOAM then numbers them.
// Leaving blocks out, rather than removing cells later, needs no further stage, maps no field and
// is the same on any number of processes.
#pragma once

#include <vector>

#include "openfoam_cases/sloshing_tank.hpp"

namespace slosh::openfoam {

// Counted from the left wall and from the bottom.
struct Cell {
  int column, row;
};

// Cells [column_begin, column_end) x [row_begin, row_end).
struct Block {
  int column_begin, column_end, row_begin, row_end;
};

class TankMesh {
 public:
  // Throws std::invalid_argument for an obstacle that is beyond the walls, off the cells' faces or
  // thinner than a cell, and for obstacles that leave no cell or cut the tank into several rooms.
  explicit TankMesh(const SloshingTank& tank);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  double length() const { return length_; }                 // [m]
  double cell_width() const { return length_ / columns_; }  // [m]
  double cell_height() const { return height_ / rows_; }    // [m]
  // Where the mesh has its origin, [m] from the tank's bottom left corner: on the roll's axis,
  // about which interFoam rotates, and in the corner without roll.
  double origin_x() const { return origin_x_; }
  double origin_z() const { return origin_z_; }
  double face_x(int column) const;  // [m], of its left side
  double face_z(int row) const;     // [m], of its lower side
  double centre_x(int column) const { return (column + 0.5) * cell_width(); }  // [m]
  double centre_z(int row) const { return (row + 0.5) * cell_height(); }       // [m]
  bool is_free(Cell cell) const;                // false beyond the walls
  bool are_alike(int column, int other) const;  // obstacles fill the same rows of both
  int free_cells(int column) const;
  int free_cells() const;

  // They meet at whole sides; one block without obstacles.
  std::vector<Block> blocks() const;
  // The free cells in OpenFOAM's order: block by block, in each row by row from the bottom.
  std::vector<Cell> cells() const;
  // Where the reference pressure is taken: of the highest free cells the one nearest the middle.
  Cell reference_cell() const;

 private:
  void leave_out(const Obstacle& obstacle);
  void check_rooms() const;
  std::size_t index(Cell cell) const {
    return static_cast<std::size_t>(cell.row) * columns_ + cell.column;
  }

  int columns_, rows_;
  double length_, height_;
  double origin_x_, origin_z_;
  std::vector<bool> filled_;                     // by obstacles
  std::vector<int> column_breaks_, row_breaks_;  // where blocks end, ascending, walls included
};

}  // namespace slosh::openfoam
