#include "openfoam_cases/geometry/liquid_edge.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <set>

#include "openfoam_cases/geometry/gauge_columns.hpp"

namespace slosh::openfoam {
namespace {

// Returns the place [m] from the line's begin where the line is half full for the last time;
// nullopt where no cell is half full. `cells` holds the numbers of the free cells, ascending, and
// `fractions` the liquid's volume fraction in each.
std::optional<double> last_half_full(const CellFaces& faces, const std::vector<int>& cells,
                                     const std::vector<double>& fractions) {
  assert(fractions.size() == cells.size());
  for (std::size_t i = cells.size(); i-- > 0;) {
    const double share = fractions[i];
    if (!(share >= 0.5)) continue;
    const bool before_wall = i + 1 == cells.size() || cells[i + 1] != cells[i] + 1;
    if (before_wall) return faces.face(cells[i]) + std::min(share, 1.0) * faces.size(cells[i]);
    return faces.at_centres(cells[i] + (share - 0.5) / (share - fractions[i + 1]));
  }
  return std::nullopt;
}

// The same in a column of cut cells, as a height: linear between the cells' centroids, and beside a
// wall the height to which the liquid fills the last cell.
double last_half_full_height(const CutMesh& mesh, int column,
                             const std::vector<double>& fractions) {
  const std::vector<int> cells = mesh.column(column);
  assert(fractions.size() == cells.size());
  for (std::size_t i = cells.size(); i-- > 0;) {
    const double share = fractions[i];
    if (!(share >= 0.5)) continue;
    const CutCell& cell = mesh.cells()[cells[i]];
    if (i + 1 == cells.size()) return Filling({cell.polygon}).level(share * cell.area);
    const CutCell& above = mesh.cells()[cells[i + 1]];
    return std::lerp(cell.centroid.z, above.centroid.z, (share - 0.5) / (share - fractions[i + 1]));
  }
  return mesh.filling(column).level(0);
}

}  // namespace

std::vector<int> bottom_columns(const TankMesh& mesh) {
  std::vector<int> columns;
  for (int column = 0; column < mesh.columns(); ++column) {
    if (mesh.is_free({column, 0})) columns.push_back(column);
  }
  return columns;
}

double front_position(const TankMesh& mesh, const std::vector<double>& fractions) {
  return last_half_full(mesh.across(), bottom_columns(mesh), fractions).value_or(0);
}

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
  if (mesh.cut()) return last_half_full_height(*mesh.cut(), column, fractions);
  const std::vector<int> rows = free_rows(mesh, column);
  return last_half_full(mesh.up(), rows, fractions).value_or(mesh.face_z(rows.front()));
}

}  // namespace slosh::openfoam
