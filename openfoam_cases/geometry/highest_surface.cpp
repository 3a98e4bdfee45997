#include "openfoam_cases/geometry/highest_surface.hpp"

#include <set>

#include "openfoam_cases/geometry/gauge_columns.hpp"
#include "openfoam_cases/geometry/half_full.hpp"

namespace slosh::openfoam {

std::vector<int> probed_columns(const SloshingTank& tank, const TankMesh& mesh) {
  std::set<int> columns;
  for (const Gauge& gauge : tank.gauges) columns.insert(nearest_column(mesh, gauge.x));
  return {columns.begin(), columns.end()};
}

std::vector<int> free_rows(const TankMesh& mesh, int column) {
  std::vector<int> rows;
  for (int row = 0; row < mesh.rows(); ++row) {
    if (mesh.is_free({column, row})) rows.push_back(row);
  }
  return rows;
}

double highest_surface(const TankMesh& mesh, int column, const std::vector<double>& fractions) {
  const std::vector<int> rows = free_rows(mesh, column);
  return last_half_full(rows, fractions).value_or(rows.front()) * mesh.cell_height();
}

}  // namespace slosh::openfoam
