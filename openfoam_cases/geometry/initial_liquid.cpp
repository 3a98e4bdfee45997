#include "openfoam_cases/geometry/initial_liquid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace slosh::openfoam {
namespace {

using std::numbers::pi;

const std::optional<InitialWave>& wave_of_level(const SloshingTank& tank) {
  return tank.initial_wave ? tank.initial_wave : tank.start_disturbance;
}
double wave_number(const SloshingTank& tank) {
  const auto& wave = wave_of_level(tank);
  return wave ? wave->mode * pi / tank.length : 0;
}
double amplitude(const SloshingTank& tank) {
  const auto& wave = wave_of_level(tank);
  return wave ? wave->amplitude : 0;
}

// Adds the places where the level crosses z inside the cell.
void add_crossings(const SloshingTank& tank, const CellBox& cell, double z,
                   std::vector<double>& places) {
  const double cosine = (z - tank.fill_depth) / amplitude(tank);
  if (!(std::abs(cosine) < 1)) return;
  const double k = wave_number(tank), angle = std::acos(cosine);
  for (int turn = 0; 2 * pi * turn <= k * cell.right + pi; ++turn)
    for (const double x : {(2 * pi * turn - angle) / k, (2 * pi * turn + angle) / k})
      if (x > cell.left && x < cell.right) places.push_back(x);
}

bool has_wavy_level(const SloshingTank& tank) { return wave_of_level(tank).has_value(); }

double share_across(const SloshingTank& tank, const TankMesh& mesh, int column) {
  if (!tank.column_width) return 1;
  return std::clamp(mesh.across().cells_over(*tank.column_width) - column, 0.0, 1.0);
}

double share_up(const SloshingTank& tank, const TankMesh& mesh, int row) {
  return std::clamp(mesh.up().cells_over(tank.fill_depth) - row, 0.0, 1.0);
}

// A straight part of the level has the slope of the level's chord and its mean height.
double area_under_wave(const SloshingTank& tank, const Polygon& polygon, double cell_width) {
  constexpr int parts = 16;
  const auto [left, right] = std::minmax_element(
      polygon.begin(), polygon.end(), [](const Corner& a, const Corner& b) { return a.x < b.x; });
  const int count = static_cast<int>(std::ceil(parts * (right->x - left->x) / cell_width));
  double area = 0;
  for (int i = 0; i < count; ++i) {
    const double from = std::lerp(left->x, right->x, static_cast<double>(i) / count),
                 to = std::lerp(left->x, right->x, (i + 1.0) / count);
    const Polygon part = right_of(right_of(polygon, {from, 0}, {from, 1}), {to, 1}, {to, 0});
    const double start = mean_height(tank, from, from), end = mean_height(tank, to, to);
    const double lift = mean_height(tank, from, to) - (start + end) / 2;
    area += area_of(right_of(part, {from, start + lift}, {to, end + lift}));
  }
  return area;
}

double share_under_wave(const SloshingTank& tank, const TankMesh& mesh, Cell cell) {
  if (mesh.is_graded())
    return share_below_level(tank, {.left = mesh.face_x(cell.column),
                                    .right = mesh.face_x(cell.column + 1),
                                    .bottom = mesh.face_z(cell.row),
                                    .top = mesh.face_z(cell.row + 1)});
  const double width = tank.length / tank.cells_x, height = tank.height / tank.cells_z;
  return share_below_level(tank, {.left = cell.column * width,
                                  .right = (cell.column + 1) * width,
                                  .bottom = cell.row * height,
                                  .top = (cell.row + 1) * height});
}

// Returns the share of the cell's whole rectangle.
double share_of_rectangle(const SloshingTank& tank, const TankMesh& mesh, Cell cell) {
  if (has_wavy_level(tank)) return share_under_wave(tank, mesh, cell);
  return share_across(tank, mesh, cell.column) * share_up(tank, mesh, cell.row);
}

}  // namespace

// sin(k to) - sin(k from) is written as a product, which avoids cancellation.
double mean_height(const SloshingTank& tank, double from, double to) {
  const double half = wave_number(tank) * (to - from) / 2;
  const double share = half == 0 ? 1 : std::sin(half) / half;
  return tank.fill_depth + amplitude(tank) * share * std::cos(wave_number(tank) * (from + to) / 2);
}

double share_below_level(const SloshingTank& tank, const CellBox& cell) {
  std::vector<double> places{cell.left, cell.right};
  add_crossings(tank, cell, cell.bottom, places);
  add_crossings(tank, cell, cell.top, places);
  std::sort(places.begin(), places.end());
  double filled = 0;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double from = places[i - 1], to = places[i];
    const double share = (mean_height(tank, from, to) - cell.bottom) / (cell.top - cell.bottom);
    filled += (to - from) * std::clamp(share, 0.0, 1.0);
  }
  return filled / (cell.right - cell.left);
}

double liquid_share(const SloshingTank& tank, const TankMesh& mesh, Cell cell) {
  if (!mesh.cut()) return share_of_rectangle(tank, mesh, cell);
  const CutCell& cut = mesh.cut()->at(cell);
  if (cut.is_whole) return share_of_rectangle(tank, mesh, cell);
  const double wet = has_wavy_level(tank) ? area_under_wave(tank, cut.polygon, mesh.cell_width())
                                          : area_below(cut.polygon, tank.fill_depth);
  return std::clamp(wet / cut.area, 0.0, 1.0);
}

// The volume is the whole rectangle less what is displaced, so that it is exact without obstacles.
double initial_volume(const SloshingTank& tank, const TankMesh& mesh) {
  if (mesh.cut()) {
    if (!has_wavy_level(tank)) return area_below(tank.outline, tank.fill_depth);
    double volume = 0;
    for (const Cell cell : mesh.cells())
      volume += liquid_share(tank, mesh, cell) * mesh.cut()->at(cell).area;
    return volume;
  }
  double displaced = 0;
  for (int row = 0; row < mesh.rows(); ++row) {
    for (int column = 0; column < mesh.columns(); ++column) {
      if (!mesh.is_free({column, row})) displaced += liquid_share(tank, mesh, {column, row});
    }
  }
  return tank.column_width.value_or(tank.length) * tank.fill_depth -
         displaced * mesh.cell_width() * mesh.cell_height();
}

double initial_depth(const SloshingTank& tank, const TankMesh& mesh, int column) {
  if (mesh.cut()) {
    double depth = 0;
    for (const int index : mesh.cut()->column(column)) {
      const CutCell& cell = mesh.cut()->cells()[index];
      depth += liquid_share(tank, mesh, cell.place) * cell.area / mesh.cell_width();
    }
    return depth;
  }
  if (has_wavy_level(tank)) return mean_height(tank, mesh.face_x(column), mesh.face_x(column + 1));
  double displaced = 0;
  for (int row = 0; row < mesh.rows(); ++row) {
    if (!mesh.is_free({column, row})) displaced += share_up(tank, mesh, row);
  }
  return share_across(tank, mesh, column) * (tank.fill_depth - displaced * mesh.cell_height());
}

// The distributions of <random> differ between standard libraries, its engines do not.
InitialWave start_disturbance(double largest, unsigned seed) {
  constexpr unsigned modes = 8;
  std::mt19937 generator(seed);
  const unsigned mode = 1 + static_cast<unsigned>(generator() % modes);
  const double size = 0.5 + 0.5 * static_cast<double>(generator()) / std::mt19937::max();
  const double sign = generator() % 2 == 0 ? 1 : -1;
  return {static_cast<int>(mode), sign * size * largest};
}

}  // namespace slosh::openfoam
