// The tanks and motions of the papers: the surge of Li et al. 2010, section 4.1, and the roll of
// Zhao et al. 2021 after Akyildiz & Unal 2006.
#pragma once

#include <cmath>
#include <numbers>

#include "reference/linear_roll.hpp"
#include "reference/linear_surge.hpp"

namespace slosh::reference {

inline constexpr Tank li_tank{.length = 1, .fill_depth = 0.35, .gravity = 9.81, .density = 1000};
// The frequency is 0.3 times the natural frequency that the paper prints.
inline constexpr SineSurge li_surge{.amplitude = 0.02, .angular_frequency = 0.3 * 4.94488};
inline constexpr double li_gauge = 0.45;  // [m] from the tank's centre

// Returns the same motion, sampled for Duhamel's integral.
inline AnySurge sampled(const SineSurge& sine, double duration, double step) {
  return {.initial_velocity = sine.amplitude * sine.angular_frequency * std::cos(sine.phase),
          .acceleration =
              [sine](double t) {
                const double omega = sine.angular_frequency;
                return -sine.amplitude * omega * omega * std::sin(omega * t + sine.phase);
              },
          .duration = duration,
          .step = step};
}

inline constexpr Tank zhao_tank{
    .length = 0.92, .fill_depth = 0.465, .gravity = 9.81, .density = 1000};
inline constexpr double zhao_axis_z = 0.31 - 0.465;   // the centre of the tank of 0.62 m
inline constexpr double zhao_gauge_z = 0.17 - 0.465;  // on the right wall
inline constexpr double zhao_amplitude = 4 * std::numbers::pi / 180;
inline constexpr double zhao_frequency = 2;  // [rad/s]

struct RollAxis {
  double x, z;
};

// Returns the roll amplitude sin(omega t) with a sudden start.
inline RollMotion sine_roll(RollAxis axis, double duration, double step) {
  const double amplitude = zhao_amplitude, omega = zhao_frequency;
  return {
      .angle = [=](double t) { return amplitude * std::sin(omega * t); },
      .rate = [=](double t) { return amplitude * omega * std::cos(omega * t); },
      .acceleration = [=](double t) { return -amplitude * omega * omega * std::sin(omega * t); },
      .axis_x = axis.x,
      .axis_z = axis.z,
      .duration = duration,
      .step = step};
}

// Returns the same roll multiplied by (1 - cos(pi t/rise))/2 up to the time `rise`.
inline RollMotion ramped_roll(RollAxis axis, double rise, double duration, double step) {
  const double b = zhao_amplitude, omega = zhao_frequency, q = std::numbers::pi / rise;
  const auto ramp = [=](double t) { return t < rise ? (1 - std::cos(q * t)) / 2 : 1; };
  const auto ramp_rate = [=](double t) { return t < rise ? q / 2 * std::sin(q * t) : 0; };
  return {.angle = [=](double t) { return b * ramp(t) * std::sin(omega * t); },
          .rate =
              [=](double t) {
                return b *
                       (ramp_rate(t) * std::sin(omega * t) + ramp(t) * omega * std::cos(omega * t));
              },
          .acceleration =
              [=](double t) {
                const double curvature = t < rise ? q * q / 2 * std::cos(q * t) : 0;
                return b * ((curvature - omega * omega * ramp(t)) * std::sin(omega * t) +
                            2 * ramp_rate(t) * omega * std::cos(omega * t));
              },
          .axis_x = axis.x,
          .axis_z = axis.z,
          .duration = duration,
          .step = step};
}

}  // namespace slosh::reference
