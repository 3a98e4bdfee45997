// The sections that the tests of polygonal tanks share, each with x from its left end and z from
// its lowest point.
#pragma once

#include <cmath>
#include <numbers>

#include "reference/section/section.hpp"
#include "reference/tank.hpp"

namespace slosh::reference {

inline Section with_outline(std::vector<Corner> outline, double fill_depth) {
  return {std::move(outline), fill_depth, 9.81, 1000};
}

inline Section rectangle(const Tank& tank) {
  const double L = tank.length, H = 2 * tank.fill_depth;
  return {{{0, 0}, {L, 0}, {L, H}, {0, H}}, tank.fill_depth, tank.gravity, tank.density};
}

// A channel with walls at 45 degrees, filled to `depth`; its tip is at x = 2 depth.
inline Section vee(double depth) {
  return with_outline({{2 * depth, 0}, {4 * depth, 2 * depth}, {0, 2 * depth}}, depth);
}

// 1 m x 0.7 m, with chamfers at 45 degrees of the lengths given in the lower corners.
inline Section chamfered(double left, double right, double fill_depth) {
  std::vector<Corner> outline;
  if (left > 0) outline.push_back({0, left});
  outline.push_back({left, 0});
  outline.push_back({1 - right, 0});
  if (right > 0) outline.push_back({1, right});
  outline.push_back({1, 0.7});
  outline.push_back({0, 0.7});
  return with_outline(outline, fill_depth);
}

// A section with neither a symmetry nor a vertical wall.
inline Section skewed() {
  return with_outline({{0.3, 0}, {0.9, 0.1}, {1.2, 0.4}, {1.1, 0.8}, {0, 0.9}, {0.1, 0.3}}, 0.6);
}

// A lying cylinder of radius 1 m, as a polygon with corners on the circle, one of them at the
// bottom.
inline Section cylinder(int corners, double fill_depth) {
  std::vector<Corner> outline;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners - std::numbers::pi / 2;
    outline.push_back({1 + std::cos(angle), 1 + std::sin(angle)});
  }
  return with_outline(outline, fill_depth);
}

}  // namespace slosh::reference
