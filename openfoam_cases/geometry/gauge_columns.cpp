#include "openfoam_cases/geometry/gauge_columns.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace slosh::openfoam {
namespace {

// In cells. A full column overshoots by less than this (1e-6 in violent flow), and any film over an
// obstacle that the mesh can represent is thicker.
constexpr double film_tolerance = 0.01;

// Returns the next column with cells in this direction, -1 where there is none.
int next_column(const TankMesh& mesh, int column, int direction) {
  do {
    column += direction;
  } while (column >= 0 && column < mesh.columns() && mesh.free_cells(column) == 0);
  return column < mesh.columns() ? column : -1;
}

// Returns the level's chord in a column of cut cells.
Chord chord_in(const CutMesh& mesh, int column, double level) {
  Chord whole{0, 0};
  for (const int cell : mesh.column(column)) {
    const Chord part = chord_at(mesh.cells()[cell].polygon, level);
    whole.middle += part.length * part.middle;
    whole.length += part.length;
  }
  if (whole.length > 0) whole.middle /= whole.length;
  return whole;
}

// A level on a face between cells is taken as that of the cells below it.
GaugeColumns cut_columns(const TankMesh& mesh, double x, double fill_depth) {
  const double level = fill_depth - 1e-6 * mesh.cell_height();
  // A chord in a corner of the column says little about the level in the middle of the column.
  const double least_chord = 0.01 * mesh.cell_width();
  const int own = nearest_column(mesh, x);
  const Chord at_own = chord_in(*mesh.cut(), own, level);
  if (at_own.length < least_chord) return {own, own, 0};
  const int towards = x < at_own.middle ? -1 : 1;
  for (const int direction : {towards, -towards}) {
    const int other = next_column(mesh, own, direction);
    if (other < 0) continue;
    const Chord at_other = chord_in(*mesh.cut(), other, level);
    if (at_other.length < least_chord) continue;
    const double weight = (x - at_own.middle) / (at_other.middle - at_own.middle);
    if (direction > 0) return {own, other, weight};
    return {other, own, 1 - weight};
  }
  return {own, own, 0};
}

}  // namespace

int nearest_column(const TankMesh& mesh, double x) {
  const double column = mesh.across().cells_over(x);
  const int own = std::clamp(static_cast<int>(std::floor(column)), 0, mesh.columns() - 1);
  if (!mesh.cut() || mesh.free_cells(own) > 0) return own;
  const int left = next_column(mesh, own, -1), right = next_column(mesh, own, 1);
  if (left < 0 || right < 0) return std::max(left, right);
  return column - left - 1 < right - column ? left : right;
}

GaugeColumns gauge_columns(const TankMesh& mesh, double x) {
  if (mesh.cut()) return cut_columns(mesh, x, mesh.fill_depth());
  const int last = mesh.columns() - 1;
  // From the first centre.
  const double column =
      mesh.is_graded() ? mesh.across().centres_to(x) : mesh.across().cells_over(x) - 0.5;
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
  if (mesh.cut()) return mesh.cut()->filling(column).level(depth * mesh.cell_width());
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
