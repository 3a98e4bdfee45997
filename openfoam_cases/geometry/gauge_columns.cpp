#include "openfoam_cases/geometry/gauge_columns.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace slosh::openfoam {
namespace {

// In cells. A full column overshoots by less than this (1e-6 in violent flow), and any film over an
// obstacle that the mesh can represent is thicker.
constexpr double film_tolerance = 0.01;

}  // namespace

int nearest_column(const TankMesh& mesh, double x) {
  const double column = x / mesh.length() * mesh.columns();
  return std::clamp(static_cast<int>(std::floor(column)), 0, mesh.columns() - 1);
}

GaugeColumns gauge_columns(const TankMesh& mesh, double x) {
  const int last = mesh.columns() - 1;
  const double column = x / mesh.length() * mesh.columns() - 0.5;  // from the first centre
  const int left = std::clamp(static_cast<int>(std::floor(column)), 0, last - 1);
  if (mesh.are_alike(left, left + 1)) return {left, left + 1, column - left};
  const int own = nearest_column(mesh, x);
  const int other = own == left ? own - 1 : own + 1;
  if (other < 0 || other > last || !mesh.are_alike(own, other)) return {own, own, 0};
  const int first = std::min(own, other);
  return {first, first + 1, column - first};
}

std::vector<int> columns_read(const SloshingTank& tank, const TankMesh& mesh) {
  std::set<int> read;
  for (const Gauge& gauge : tank.gauges) {
    const GaugeColumns columns = gauge_columns(mesh, gauge.x);
    read.insert({columns.left, columns.right});
  }
  return {read.begin(), read.end()};
}

std::string column_name(int index) { return "column_" + std::to_string(index); }

double surface_level(const TankMesh& mesh, int column, double depth) {
  double level = depth;
  const double film = film_tolerance * mesh.cell_height();
  bool on_ground = true;
  for (int row = 0; row < mesh.rows(); ++row) {
    if (mesh.is_free({column, row})) {
      on_ground = false;
    } else if (on_ground || level > row * mesh.cell_height() + film) {
      level += mesh.cell_height();
    } else {
      break;
    }
  }
  return level;
}

}  // namespace slosh::openfoam
