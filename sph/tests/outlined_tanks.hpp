// Tanks that are not rectangles, for the tests: one with chamfers, and a lying cylinder.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "sph/tests/surging_scene.hpp"

namespace slosh::sph {

// 1 m long and 0.7 m high, with chamfers of 45 degrees.
inline std::vector<Corner> chamfered_outline(double chamfer) {
  const double c = chamfer, l = 1, h = 0.7;
  return {{c, 0}, {l - c, 0}, {l, c}, {l, h - c}, {l - c, h}, {c, h}, {0, h - c}, {0, c}};
}

inline Scene chamfered_scene(double particle_spacing, double duration) {
  Scene scene = still_scene(particle_spacing, duration);
  scene.tank_height = 0.7;
  scene.outline = chamfered_outline(0.15);
  return scene;
}

// A polygon of 128 corners with the area of a circle of the diameter 1 m, and a flat bottom.
inline std::vector<Corner> cylinder_outline() {
  constexpr int count = 128;
  const double step = 2 * std::numbers::pi / count, radius = 0.5 * std::sqrt(step / std::sin(step)),
               flat = radius * std::cos(0.5 * step);
  std::vector<Corner> corners;
  for (int k = 0; k < count; ++k) {
    const double angle = -0.5 * std::numbers::pi + step * (k + 0.5);
    const double z = flat + radius * std::sin(angle);
    corners.push_back({flat + radius * std::cos(angle), std::abs(z) < 1e-12 ? 0 : z});
  }
  return corners;
}

inline Scene cylinder_scene(double particle_spacing, double duration) {
  Scene scene = still_scene(particle_spacing, duration);
  scene.outline = cylinder_outline();
  scene.tank_length = scene.tank_height = 0;
  for (const Corner& c : scene.outline) {
    scene.tank_length = std::max(scene.tank_length, c.x);
    scene.tank_height = std::max(scene.tank_height, c.z);
  }
  scene.fill_depth = 0.5 * scene.tank_height;
  return scene;
}

}  // namespace slosh::sph
