#include "sph/neighbours/ghost_fill.hpp"

#include <cmath>
#include <cstdint>

#include "sph/neighbours/cell_grid.hpp"

namespace slosh::sph {
namespace {

// The integral of shape(|q|) over all q, by the midpoint rule.
double integral_along_a_line(const KernelFunction& kernel) {
  constexpr int steps = 1000;
  double sum = 0;
  for (int k = 0; k < steps; ++k) sum += kernel.shape(kernel_support * (k + 0.5) / steps);
  return 2 * kernel_support * sum / steps;
}

// A node within an obstacle has no room; in a corner of the tank it has a quarter and more.
constexpr double least_room = 0.05;

}  // namespace

void GhostFill::initialise(const KernelFunction& kernel, const std::vector<SolidPlace>& places,
                           double h, double dp, const LineOfSight& sight) {
  fall_ = dp / h * kernel.normalisation * integral_along_a_line(kernel);
  if (places.empty()) return;
  const double reach = kernel_support * h;
  const auto [left, right] = std::minmax_element(
      places.begin(), places.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  const auto [low, high] = std::minmax_element(
      places.begin(), places.end(), [](const auto& a, const auto& b) { return a.z < b.z; });
  CellGrid grid(left->x, right->x, low->z, high->z, reach, reach);
  std::vector<std::uint32_t> cells, order;
  for (const SolidPlace& place : places) cells.push_back(grid.cell(place.x, place.z));
  grid.sort(cells, order);
  room_.clear();
  for (const SolidPlace& at : places) {
    double solid = 0;
    for (int row = grid.row(at.node_z - reach); row <= grid.row(at.node_z + reach); ++row) {
      const IndexRange near =
          grid.run(row, grid.column(at.node_x - reach), grid.column(at.node_x + reach));
      for (std::size_t k = near.begin; k < near.end; ++k) {
        const SolidPlace& b = places[order[k]];
        if (sight.exists() && sight.hiding_face({at.node_x, at.node_z}, {b.x, b.z}) != b.face)
          continue;
        solid +=
            b.cell_share * dp * dp * kernel.shape(std::hypot(b.x - at.node_x, b.z - at.node_z) / h);
      }
    }
    const double whole = h * h / kernel.normalisation;
    room_.push_back(std::max(whole - solid, least_room * whole));
  }
}

}  // namespace slosh::sph
