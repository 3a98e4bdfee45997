#include "openfoam_cases/geometry/wavy_level.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

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

// Where the level passes z inside the cell.
void add_crossings(const SloshingTank& tank, const CellBox& cell, double z,
                   std::vector<double>& places) {
  const double cosine = (z - tank.fill_depth) / amplitude(tank);
  if (!(std::abs(cosine) < 1)) return;
  const double k = wave_number(tank), angle = std::acos(cosine);
  for (int turn = 0; 2 * pi * turn <= k * cell.right + pi; ++turn)
    for (const double x : {(2 * pi * turn - angle) / k, (2 * pi * turn + angle) / k})
      if (x > cell.left && x < cell.right) places.push_back(x);
}

}  // namespace

bool has_wavy_level(const SloshingTank& tank) { return wave_of_level(tank).has_value(); }

// sin(k to) - sin(k from) as a product, which does not cancel.
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

}  // namespace slosh::openfoam
