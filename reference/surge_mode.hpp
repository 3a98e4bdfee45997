// One antisymmetric natural mode of a surging rectangular tank and its equation of motion,
//   eta_n'' + omega_n^2 eta_n = -coupling X''(t),   eta_n(0) = 0,
//   lambda_n = (2n+1) pi / L,   coupling = c_n lambda_n tanh(lambda_n h),
// where x = sum c_n sin(lambda_n x) on |x| <= a = L/2, c_n = 2 (-1)^n / (a lambda_n^2).
#pragma once

#include <optional>
#include <vector>

#include "reference/linear_surge.hpp"

namespace slosh::reference {

struct SurgeMode {
  double wave_number;        // lambda_n [1/m]
  double depth_factor;       // tanh(lambda_n h)
  double coupling;           // [-], of the wall's acceleration to the mode's
  double natural_frequency;  // omega_n [rad/s]
  double initial_rate;       // eta_n'(0) [m/s]
};

struct ModeState {
  double elevation;     // eta_n [m]
  double rate;          // eta_n' [m/s]
  double acceleration;  // eta_n'' [m/s2]
};

// The first `count` modes. `initial_velocity` is the tank's against the liquid at rest at t = 0
// [m/s]: X'(0) for a start at rest in the earth's frame, 0 for one at rest in the tank. With a gas,
// the frequencies are those of the two-layer theory. Throws std::invalid_argument for an impossible
// tank, gas, velocity or count.
std::vector<SurgeMode> surge_modes(const Tank& tank, const std::optional<Gas>& gas,
                                   double initial_velocity, int count);

}  // namespace slosh::reference
