// One antisymmetric natural mode of a moving rectangular tank and its equation of motion,
//   zeta_n'' + omega_n^2 zeta_n = -coupling q''(t),   zeta_n(0) = 0,
//   lambda_n = (2n+1) pi / L,   x = sum c_n sin(lambda_n x) on |x| <= a = L/2,
//   c_n = 2 (-1)^n / (a lambda_n^2),   T_n = tanh(lambda_n h).
// Surge: q = X [m] and zeta_n = eta_n, the elevation in the tank;
//   coupling = c_n lambda_n T_n.
// Roll: q = theta [rad] and zeta_n = eta_n + c_n theta, the elevation above the level plane that
// the still surface becomes, so that gravity's tilt needs no forcing of its own;
//   coupling = c_n (z0 lambda_n T_n + 1 - 2/cosh(lambda_n h)),
// z0 the axis's height above the still surface; linear_roll.hpp has the derivation.
#pragma once

#include <optional>
#include <vector>

#include "reference/linear_surge.hpp"

namespace slosh::reference {

struct TankMode {
  double wave_number;        // lambda_n [1/m]
  double depth_factor;       // T_n
  double line;               // c_n [m], the mode's share of the line x
  double coupling;           // surge: [-]; roll: [m]
  double natural_frequency;  // omega_n [rad/s]
  double initial_rate;       // zeta_n'(0) [m/s]
};

struct ModeState {
  double elevation;     // zeta_n [m]
  double rate;          // zeta_n' [m/s]
  double acceleration;  // zeta_n'' [m/s2]
};

// The first `count` modes of a surging tank. `initial_velocity` is the tank's against the liquid at
// rest at t = 0 [m/s]: X'(0) for a start at rest in the earth's frame, 0 for one at rest in the
// tank. With a gas, the frequencies are those of the two-layer theory. Throws std::invalid_argument
// for an impossible tank, gas, velocity or count.
std::vector<TankMode> surge_modes(const Tank& tank, const std::optional<Gas>& gas,
                                  double initial_velocity, int count);

struct RollStart {
  Start start;
  double axis_z;  // [m] above the still surface
  double rate;    // theta'(0) [rad/s]
};

// The first `count` modes of a rolling tank, as above; they stand still in the tank, zeta_n'(0) =
// c_n theta'(0), or in the earth's frame, where the potential vanishes on the surface and leaves
// zeta_n'(0) = -coupling theta'(0).
std::vector<TankMode> roll_modes(const Tank& tank, const std::optional<Gas>& gas,
                                 const RollStart& roll, int count);

// sin(lambda_n x) of each mode, its shape on the surface.
std::vector<double> surface_shapes(const std::vector<TankMode>& modes, double x);

// cosh(lambda_n(z+h))/cosh(lambda_n h) and sinh(lambda_n(z+h))/cosh(lambda_n h), which for z <= 0
// overflow nowhere.
struct DepthProfile {
  double cosh, sinh;
};
DepthProfile depth_profile(double lambda, double z, double depth);

}  // namespace slosh::reference
