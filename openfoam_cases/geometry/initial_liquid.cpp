#include "openfoam_cases/geometry/initial_liquid.hpp"

#include <algorithm>

#include "openfoam_cases/geometry/wavy_level.hpp"

namespace slosh::openfoam {
namespace {

double share_across(const SloshingTank& tank, int column) {
  if (!tank.column_width) return 1;
  return std::clamp(*tank.column_width / tank.length * tank.cells_x - column, 0.0, 1.0);
}

double share_up(const SloshingTank& tank, int row) {
  return std::clamp(tank.fill_depth / tank.height * tank.cells_z - row, 0.0, 1.0);
}

double share_under_wave(const SloshingTank& tank, Cell cell) {
  const double width = tank.length / tank.cells_x, height = tank.height / tank.cells_z;
  return share_below_level(tank, {.left = cell.column * width,
                                  .right = (cell.column + 1) * width,
                                  .bottom = cell.row * height,
                                  .top = (cell.row + 1) * height});
}

}  // namespace

double liquid_share(const SloshingTank& tank, Cell cell) {
  if (has_wavy_level(tank)) return share_under_wave(tank, cell);
  return share_across(tank, cell.column) * share_up(tank, cell.row);
}

// The whole rectangle less what is displaced: free of round-off without obstacles.
double initial_volume(const SloshingTank& tank, const TankMesh& mesh) {
  double displaced = 0;
  for (int row = 0; row < mesh.rows(); ++row) {
    for (int column = 0; column < mesh.columns(); ++column) {
      if (!mesh.is_free({column, row})) displaced += liquid_share(tank, {column, row});
    }
  }
  return tank.column_width.value_or(tank.length) * tank.fill_depth -
         displaced * mesh.cell_width() * mesh.cell_height();
}

double initial_depth(const SloshingTank& tank, const TankMesh& mesh, int column) {
  if (has_wavy_level(tank))
    return mean_height(tank, column * mesh.cell_width(), (column + 1) * mesh.cell_width());
  double displaced = 0;
  for (int row = 0; row < mesh.rows(); ++row) {
    if (!mesh.is_free({column, row})) displaced += share_up(tank, row);
  }
  return share_across(tank, column) * (tank.fill_depth - displaced * mesh.cell_height());
}

}  // namespace slosh::openfoam
