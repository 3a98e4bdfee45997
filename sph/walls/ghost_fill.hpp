// How much of a ghost particle's volume counts: as much as there is liquid at its node. A mirror
// image exists only where its owner does, but a ghost particle also stands above the surface, where
// it would pull at the liquid's edge.
//
// The kernel sum of the liquid at a node, over what the solids leave of the kernel there, is 1 in
// the liquid, 1/2 at its surface, and falls by dp W_1 per spacing across it, where W_1 is the
// kernel's integral along the surface. The share is 1 where the sum is that of the outermost row of
// a lattice, half a spacing inside, 0 half a spacing outside, and linear in between.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "sph/neighbours/cell_grid.hpp"
#include "sph/terms/kernels.hpp"
#include "sph/walls/solid_particles.hpp"

namespace slosh::sph {

class GhostFill {
 public:
  // The places must have their final order; h is the smoothing length and dp the spacing [m]. A
  // node sees the solids that `sight` lets it see.
  template <class Kernel>
  void initialise(const Kernel&, const std::vector<SolidPlace>& places, double h, double dp,
                  const LineOfSight& sight) {
    fall_ = dp / h * Kernel::normalisation * integral_along_a_line<Kernel>();
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
          solid += b.cell_share * dp * dp *
                   Kernel::shape(std::hypot(b.x - at.node_x, b.z - at.node_z) / h);
        }
      }
      const double whole = h * h / Kernel::normalisation;
      room_.push_back(std::max(whole - solid, least_room * whole));
    }
  }

  // Returns the share of ghost particle i, whose node has this kernel sum of the liquid, without
  // the kernel's normalisation and 1/h^2 [m2].
  double share(std::size_t i, double liquid) const {
    return std::clamp(0.5 + (liquid / room_[i] - 0.5) / fall_, 0.0, 1.0);
  }

  template <class Visit>
  void for_each_named_field(const Visit& visit) {
    visit("room", room_);
  }

 private:
  // The integral of shape(|q|) over all q, by the midpoint rule.
  template <class Kernel>
  static double integral_along_a_line() {
    constexpr int steps = 1000;
    double sum = 0;
    for (int k = 0; k < steps; ++k) sum += Kernel::shape(kernel_support * (k + 0.5) / steps);
    return 2 * kernel_support * sum / steps;
  }

  // A node within an obstacle has no room; in a corner of the tank it has a quarter and more.
  static constexpr double least_room = 0.05;

  double fall_ = 0;           // of the kernel sum across a spacing at the surface
  std::vector<double> room_;  // the kernel sum of a whole liquid at each node, as in share() [m2]
};

}  // namespace slosh::sph
