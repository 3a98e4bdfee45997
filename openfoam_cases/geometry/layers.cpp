#include "openfoam_cases/geometry/layers.hpp"

#include <fmt/format.h>

#include <cmath>

#include "openfoam_cases/errors.hpp"
#include "openfoam_cases/geometry/growth_ratio.hpp"

namespace slosh::openfoam {
namespace {

constexpr double expansion_unless_given = 7;
constexpr double largest_layer_ratio = 2;

// Returns the depth of the layers over the thickness of the first.
double depth_in_first(int count, double ratio) {
  double sum = 0, size = 1;
  for (int i = 0; i < count; ++i, size *= ratio) sum += size;
  return sum;
}

}  // namespace

void check_layers(const SloshingTank& tank) {
  if (!tank.gap) return;
  const auto [breadth, cells] = *tank.gap;
  require(breadth > 0 && std::isfinite(breadth), "gap breadth", breadth, "a positive number of m");
  require(cells >= 4, "gap cells", cells, "at least 4");
  if (!tank.wall_cell) return;
  const double thinnest = breadth / 2 / depth_in_first(cells, largest_layer_ratio);
  require(
      *tank.wall_cell >= thinnest, "wall_cell", *tank.wall_cell,
      fmt::format("at least {:.3g} m for {} cells across {} m, half of the gap, as each cell is "
                  "at most {} times as thick as its neighbour",
                  thinnest, cells, breadth / 2, largest_layer_ratio));
}

Layers::Layers(const SloshingTank& tank) {
  if (!tank.gap) return;
  is_half_gap_ = true;
  count_ = tank.gap->cells;
  depth_ = tank.gap->breadth / 2;
  if (!tank.wall_cell)
    ratio_ = std::pow(expansion_unless_given, 1.0 / (count_ - 1));
  else if (*tank.wall_cell < depth_ / count_)
    ratio_ = growth_ratio([this](double ratio) { return depth_in_first(count_, ratio); },
                          depth_ / *tank.wall_cell, largest_layer_ratio);
}

double Layers::at_wall() const { return depth_ * share(0); }

double Layers::share(int layer) const {
  return std::pow(ratio_, layer) / depth_in_first(count_, ratio_);
}

double Layers::expansion() const { return std::pow(ratio_, count_ - 1); }

double Layers::measured_y() const { return depth_ * (1 - share(count_ - 1) / 2); }

}  // namespace slosh::openfoam
