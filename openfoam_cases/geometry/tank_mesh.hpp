// The mesh of the tank without the cells that its obstacles fill: its cells, the blocks of
// which blockMesh builds it, and the order in which OpenFOAM then numbers the cells. Leaving out
// blocks, rather than removing cells later, needs no further stage, maps no field and gives the
// same mesh on any number of processes.
//
// The cells are uniform, or graded towards the walls (cell_faces.hpp) in a tank without obstacles.
//
// In a tank with an outline the cells are those of a cut mesh. A cell has its own place, and a
// place whose part was merged into another cell has none, as one that an obstacle fills.
//
// All of this is in the plane of x and z. Across it the mesh has its layers, which are alike.
#pragma once

#include <memory>
#include <vector>

#include "openfoam_cases/geometry/cell_faces.hpp"
#include "openfoam_cases/geometry/layers.hpp"
#include "openfoam_cases/outline/cut_mesh.hpp"
#include "openfoam_cases/sloshing_tank.hpp"

namespace slosh::openfoam {

// The cells [column_begin, column_end) x [row_begin, row_end).
struct Block {
  int column_begin, column_end, row_begin, row_end;
};

class TankMesh {
 public:
  // Throws std::invalid_argument for an obstacle that reaches beyond the walls, whose edges are not
  // on the cells' faces, or which is thinner than a cell, and for obstacles that leave no cell or
  // divide the tank into several parts; for an outline as check_outline() and CutMesh do; for
  // graded cells as CellFaces does, and beside obstacles or an outline; for layers as
  // check_layers() does, and beside obstacles or an outline.
  explicit TankMesh(const SloshingTank& tank);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  double length() const { return length_; }                 // [m]
  double fill_depth() const { return fill_depth_; }         // [m]
  double cell_width() const { return length_ / columns_; }  // [m], of a cell on average
  double cell_height() const { return height_ / rows_; }    // [m], likewise
  const CellFaces& across() const { return across_; }       // of the columns
  const CellFaces& up() const { return up_; }               // of the rows
  const Layers& layers() const { return layers_; }
  bool is_graded() const { return across_.is_graded(); }
  // The mesh's origin [m] from the tank's bottom left corner: the roll's axis, about which
  // interFoam rotates, or the corner itself without roll.
  double origin_x() const { return origin_x_; }
  double origin_z() const { return origin_z_; }
  double face_x(int column) const { return across_.face(column); }      // [m], of its left side
  double face_z(int row) const { return up_.face(row); }                // [m], of its lower side
  double centre_x(int column) const { return across_.centre(column); }  // [m]
  double centre_z(int row) const { return up_.centre(row); }            // [m]
  bool is_free(Cell cell) const;                                        // false beyond the walls
  bool are_alike(int column, int other) const;  // whether obstacles fill the same rows of both
  int free_cells(int column) const;
  int free_cells() const;
  int cells_in_all_layers() const { return free_cells() * layers_.count(); }

  const CutMesh* cut() const { return cut_.get(); }  // nullptr without an outline
  // Of a free cell [m]: its centroid, and a place inside it, which differs from the centroid only
  // where that is outside.
  Corner centre(Cell cell) const;
  Corner inside(Cell cell) const;
  double whole_cells(Cell cell) const;  // a free cell's area, in mean cells
  double room() const;                  // [m2], of all free cells
  // Returns the depth [m] over a whole cell's width of the liquid that fills this fraction of a
  // column.
  double depth_of(int column, double filling) const;

  // Returns blocks that meet at whole sides; without obstacles there is one. With an outline there
  // are none.
  std::vector<Block> blocks() const;
  // Returns the free cells in OpenFOAM's order: block by block, and in each block row by row from
  // the bottom; with an outline in that of cell_order.hpp.
  std::vector<Cell> cells() const;
  // Returns the same with each row once for each layer, which is OpenFOAM's order of all cells.
  std::vector<Cell> cells_of_all_layers() const;
  // Returns the cell of the reference pressure: of the highest free cells the one nearest the
  // middle. With an outline it is a whole cell, unless there is none.
  Cell reference_cell() const;

 private:
  void cut_by(const SloshingTank& tank);
  void leave_out(const Obstacle& obstacle);
  void check_rooms() const;
  std::size_t index(Cell cell) const {
    return static_cast<std::size_t>(cell.row) * columns_ + cell.column;
  }

  int columns_, rows_;
  double length_, height_, fill_depth_;
  CellFaces across_, up_;
  Layers layers_;
  double origin_x_, origin_z_;
  std::vector<bool> filled_;  // by obstacles, or without a cell of the outline's mesh
  std::vector<int> column_breaks_, row_breaks_;  // where blocks end, ascending, walls included
  std::shared_ptr<const CutMesh> cut_;
};

}  // namespace slosh::openfoam
