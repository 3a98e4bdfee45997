// Scenes for the solver's tests: a tank at rest, carried along, or surging as Li et al. 2010,
// section 4.1, have it.
#pragma once

#include <cmath>
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

}  // namespace slosh::sph
