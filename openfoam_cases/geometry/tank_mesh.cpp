#include "openfoam_cases/geometry/tank_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "openfoam_cases/errors.hpp"

namespace slosh::openfoam {
namespace {

// An obstacle's edge may be this far from a cell's face, in cells. This allows for lengths that
// were rounded in a case file, and no run resolves it.
constexpr double snap_tolerance = 0.01;

// Returns the index of the face on which the edge lies.
int face_of(const char* key, double edge, double tank_size, int cells) {
  const double cell = tank_size / cells;
  const double nearest = std::round(edge / cell);
  require(nearest >= 0 && nearest <= cells, key, edge,
          fmt::format("between the tank's walls, 0 and {} m", tank_size));
  require(
      std::abs(edge / cell - nearest) <= snap_tolerance, key, edge,
      fmt::format("a multiple of the cells' {:.6g} m, to {} of a cell (the nearest is {:.6g} m)",
                  cell, snap_tolerance, nearest * cell));
  return static_cast<int>(nearest);
}

CellFaces faces_of(const SloshingTank& tank, double length, int cells, const char* key) {
  if (!tank.wall_cell) return CellFaces(length, cells);
  require(tank.outline.empty() && tank.obstacles.empty(), "wall_cell", *tank.wall_cell,
          "none in a tank with an outline or obstacles, whose cells are uniform");
  return CellFaces(length, cells, *tank.wall_cell, key);
}

void insert_sorted(std::vector<int>& breaks, int value) {
  const auto at = std::lower_bound(breaks.begin(), breaks.end(), value);
  if (at == breaks.end() || *at != value) breaks.insert(at, value);
}

}  // namespace

TankMesh::TankMesh(const SloshingTank& tank)
    : columns_(tank.cells_x),
      rows_(tank.cells_z),
      length_(tank.length),
      height_(tank.height),
      fill_depth_(tank.fill_depth),
      across_(faces_of(tank, length_, columns_, "cells_x")),
      up_(faces_of(tank, height_, rows_, "cells_z")),
      layers_(tank),
      origin_x_(tank.roll ? tank.roll->axis_x : 0),
      origin_z_(tank.roll ? tank.roll->axis_z : 0),
      filled_(static_cast<std::size_t>(columns_) * rows_, false),
      column_breaks_{0, columns_},
      row_breaks_{0, rows_} {
  check_layers(tank);
  require(!tank.gap || (tank.outline.empty() && tank.obstacles.empty()), "gap breadth",
          layers_.depth() * 2, "no gap in three dimensions of a tank with an outline or obstacles");
  if (!tank.outline.empty()) cut_by(tank);
  for (const Obstacle& obstacle : tank.obstacles) leave_out(obstacle);
  if (!tank.obstacles.empty()) check_rooms();
}

void TankMesh::cut_by(const SloshingTank& tank) {
  check_outline(tank);
  if (!tank.obstacles.empty())
    throw std::invalid_argument(
        "OpenFOAM tank: obstacles: expected none in a tank with an outline, which can follow an "
        "obstacle that touches a wall");
  cut_ = std::make_shared<CutMesh>(tank.outline, UniformGrid{length_, height_, columns_, rows_},
                                   tank.processes);
  filled_.assign(filled_.size(), true);
  for (const CutCell& cell : cut_->cells()) filled_[index(cell.place)] = false;
}

void TankMesh::leave_out(const Obstacle& obstacle) {
  const int left = face_of("obstacle left", obstacle.left, length_, columns_);
  const int right = face_of("obstacle right", obstacle.right, length_, columns_);
  const int bottom = face_of("obstacle bottom", obstacle.bottom, height_, rows_);
  const int top = face_of("obstacle top", obstacle.top, height_, rows_);
  require(left < right, "obstacle right", obstacle.right,
          fmt::format("a cell or more beyond the left edge at {} m", obstacle.left));
  require(bottom < top, "obstacle top", obstacle.top,
          fmt::format("a cell or more above the lower edge at {} m", obstacle.bottom));
  for (int row = bottom; row < top; ++row) {
    for (int column = left; column < right; ++column) filled_[index({column, row})] = true;
  }
  for (const int face : {left, right}) insert_sorted(column_breaks_, face);
  for (const int face : {bottom, top}) insert_sorted(row_breaks_, face);
}

// Throws where the tank is divided: each part would need a reference pressure and a liquid of its
// own.
void TankMesh::check_rooms() const {
  const auto first = std::find(filled_.begin(), filled_.end(), false);
  if (first == filled_.end()) {
    throw std::invalid_argument("OpenFOAM tank: the obstacles fill the tank");
  }
  std::vector<bool> reached = filled_;
  const int start = static_cast<int>(first - filled_.begin());
  std::vector<Cell> open{{start % columns_, start / columns_}};
  reached[index(open.back())] = true;
  while (!open.empty()) {
    const Cell cell = open.back();
    open.pop_back();
    for (const Cell next : {Cell{cell.column - 1, cell.row}, Cell{cell.column + 1, cell.row},
                            Cell{cell.column, cell.row - 1}, Cell{cell.column, cell.row + 1}}) {
      if (!is_free(next) || reached[index(next)]) continue;
      reached[index(next)] = true;
      open.push_back(next);
    }
  }
  if (std::find(reached.begin(), reached.end(), false) != reached.end()) {
    throw std::invalid_argument(
        "OpenFOAM tank: the obstacles cut the tank into rooms without a connection, expected one");
  }
}

bool TankMesh::is_free(Cell cell) const {
  return cell.column >= 0 && cell.column < columns_ && cell.row >= 0 && cell.row < rows_ &&
         !filled_[index(cell)];
}

bool TankMesh::are_alike(int column, int other) const {
  for (int row = 0; row < rows_; ++row) {
    if (is_free({column, row}) != is_free({other, row})) return false;
  }
  return true;
}

int TankMesh::free_cells(int column) const {
  int count = 0;
  for (int row = 0; row < rows_; ++row) count += is_free({column, row});
  return count;
}

int TankMesh::free_cells() const {
  return static_cast<int>(std::count(filled_.begin(), filled_.end(), false));
}

Corner TankMesh::centre(Cell cell) const {
  return cut_ ? cut_->at(cell).centroid : Corner{centre_x(cell.column), centre_z(cell.row)};
}

Corner TankMesh::inside(Cell cell) const { return cut_ ? cut_->at(cell).inside : centre(cell); }

double TankMesh::whole_cells(Cell cell) const {
  const double mean = cell_width() * cell_height();
  if (is_graded()) return across_.size(cell.column) * up_.size(cell.row) / mean;
  return cut_ && !cut_->at(cell).is_whole ? cut_->at(cell).area / mean : 1;
}

double TankMesh::room() const {
  return cut_ ? area_of(cut_->outline()) : free_cells() * cell_width() * cell_height();
}

double TankMesh::depth_of(int column, double filling) const {
  if (cut_) return filling * cut_->filling(column).area() / cell_width();
  return filling * free_cells(column) * cell_height();
}

std::vector<Block> TankMesh::blocks() const {
  std::vector<Block> blocks;
  if (cut_) return blocks;
  for (std::size_t k = 0; k + 1 < row_breaks_.size(); ++k) {
    for (std::size_t i = 0; i + 1 < column_breaks_.size(); ++i) {
      if (!is_free({column_breaks_[i], row_breaks_[k]})) continue;
      blocks.push_back(
          {column_breaks_[i], column_breaks_[i + 1], row_breaks_[k], row_breaks_[k + 1]});
    }
  }
  return blocks;
}

std::vector<Cell> TankMesh::cells() const {
  std::vector<Cell> cells;
  if (cut_) {
    for (const CutCell& cell : cut_->cells()) cells.push_back(cell.place);
    return cells;
  }
  for (const Block& block : blocks()) {
    for (int row = block.row_begin; row < block.row_end; ++row) {
      for (int column = block.column_begin; column < block.column_end; ++column) {
        cells.push_back({column, row});
      }
    }
  }
  return cells;
}

// A mesh of several layers is one block.
std::vector<Cell> TankMesh::cells_of_all_layers() const {
  const std::vector<Cell> plane = cells();
  if (!layers_.is_half_gap()) return plane;
  std::vector<Cell> all;
  for (auto row = plane.begin(); row != plane.end(); row += columns_)
    for (int layer = 0; layer < layers_.count(); ++layer)
      all.insert(all.end(), row, row + columns_);
  return all;
}

Cell TankMesh::reference_cell() const {
  for (const bool takes_cut_cells : {false, true}) {
    for (int row = rows_ - 1; row >= 0; --row) {
      const int middle = columns_ / 2;
      for (int offset = 0; offset < columns_; ++offset) {
        for (const Cell cell : {Cell{middle + offset, row}, Cell{middle - offset, row}}) {
          const bool is_cut = cut_ && is_free(cell) && !cut_->at(cell).is_whole;
          if (is_free(cell) && (takes_cut_cells || !is_cut)) return cell;
        }
      }
    }
  }
  throw std::invalid_argument("OpenFOAM tank: the obstacles fill the tank");
}

}  // namespace slosh::openfoam
