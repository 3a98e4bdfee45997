// The tank and the motion of Li et al. 2010, section 4.1.
#pragma once

#include <cmath>

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

}  // namespace slosh::reference
