// A small tank that surges and rolls about an axis off its middle.
#pragma once

#include "sph/tests/surging_scene.hpp"

namespace slosh::sph {

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

}  // namespace slosh::sph
