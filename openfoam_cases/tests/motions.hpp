// Rolls of a tank.
#pragma once

#include <algorithm>
#include <cmath>

#include "openfoam_cases/sloshing_tank.hpp"

namespace slosh::openfoam {

// Returns theta(t) = A sin(omega t) [rad] with a sudden start and the liquid at rest in the tank.
inline Roll harmonic_roll(double amplitude, double omega, double axis_x, double axis_z) {
  return {
      .angle = [=](double t) { return amplitude * std::sin(omega * t); },
      .rate = [=](double t) { return amplitude * omega * std::cos(omega * t); },
      .acceleration = [=](double t) { return -amplitude * omega * omega * std::sin(omega * t); },
      .axis_x = axis_x,
      .axis_z = axis_z,
      .initial_relative_rate = 0};
}

// Returns a roll from 0 to `angle` over `duration` with continuous rate and acceleration.
inline Roll slow_roll(double angle, double duration, double axis_x, double axis_z) {
  const auto share = [=](double t) { return std::min(t / duration, 1.0); };
  return {.angle =
              [=](double t) {
                const double s = share(t);
                return angle * s * s * s * (10 - 15 * s + 6 * s * s);
              },
          .rate =
              [=](double t) {
                const double s = share(t);
                return angle / duration * 30 * s * s * (1 - s) * (1 - s);
              },
          .acceleration =
              [=](double t) {
                const double s = share(t);
                return angle / (duration * duration) * 60 * s * (1 - s) * (1 - 2 * s);
              },
          .axis_x = axis_x,
          .axis_z = axis_z,
          .initial_relative_rate = 0};
}

}  // namespace slosh::openfoam
