// Scenes for the solver's tests: a tank at rest, carried along, surging as Li et al. 2010, section
// 4.1, have it, rolling, and tanks that are not rectangles.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "sph/simulation.hpp"

namespace slosh::sph {

inline Scene still_scene(double particle_spacing, double duration) {
  return {.tank_length = 1,
          .tank_height = 1,
          .fill_depth = 0.35,
          .gravity = 9.81,
          .rest_density = 1000,
          .displacement = [](double) { return 0.0; },
          .velocity = [](double) { return 0.0; },
          .acceleration = [](double) { return 0.0; },
          .duration = duration,
          .sample_interval = 0.01,
          .particle_spacing = particle_spacing,
          .surface_particle_spacing = particle_spacing,
          .gauges = {{"left", 0.05}, {"right", 0.95}},
          .record_snapshot = {}};
}

inline Scene carried_scene(double particle_spacing, double duration, double speed) {
  Scene scene = still_scene(particle_spacing, duration);
  scene.displacement = [=](double t) { return speed * t; };
  scene.velocity = [=](double) { return speed; };
  scene.start = Start::tank;
  return scene;
}

// The paper's frequency, 0.3 times its natural one.
inline constexpr double surge_frequency = 0.3 * 4.94488;  // [rad/s]

inline Scene surging_scene(double particle_spacing, double duration, double amplitude = 0.02) {
  Scene scene = still_scene(particle_spacing, duration);
  const double omega = surge_frequency;
  scene.displacement = [=](double t) { return amplitude * std::sin(omega * t); };
  scene.velocity = [=](double t) { return amplitude * omega * std::cos(omega * t); };
  scene.acceleration = [=](double t) { return -amplitude * omega * omega * std::sin(omega * t); };
  return scene;
}

// A column of 0.2 m by 0.4 m in a tank of 1 m.
inline Scene dam_scene(double spacing, double duration) {
  Scene scene = still_scene(spacing, duration);
  scene.tank_height = 0.6;
  scene.fill_depth = 0.4;
  scene.column_width = 0.2;
  return scene;
}

inline Scene with_obstacle(Scene scene, const Rectangle& obstacle) {
  scene.obstacles.push_back(obstacle);
  return scene;
}

// A small tank that surges and rolls about an axis off its middle.
inline Scene surging_and_rolling_scene(double particle_spacing, double duration) {
  Scene scene = still_scene(particle_spacing, duration);
  scene.tank_length = 0.8;
  scene.tank_height = 0.5;
  scene.fill_depth = 0.24;
  const double b = 0.01, surge = 3, angle = 0.06, roll = 4.5;
  scene.displacement = [=](double t) { return b * std::sin(surge * t); };
  scene.velocity = [=](double t) { return b * surge * std::cos(surge * t); };
  scene.acceleration = [=](double t) { return -b * surge * surge * std::sin(surge * t); };
  scene.roll = Roll{[=](double t) { return angle * std::sin(roll * t); },
                    [=](double t) { return angle * roll * std::cos(roll * t); },
                    [=](double t) { return -angle * roll * roll * std::sin(roll * t); }, 0.3, 0.1};
  scene.gauges = {{"left", 0.04}, {"right", 0.76}};
  scene.pressure_gauges = {{"B", Wall::left, 0.1, 0.01}};
  return scene;
}

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
