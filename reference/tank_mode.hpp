// The antisymmetric natural modes of a moving rectangular tank. x is measured from the tank's
// CENTRE and z up from the still surface. The n-th mode obeys
//   zeta_n'' + omega_n^2 zeta_n = -coupling q''(t),   zeta_n(0) = 0,
//   lambda_n = (2n+1) pi / L,   x = sum c_n sin(lambda_n x) on |x| <= a = L/2,
//   c_n = 2 (-1)^n / (a lambda_n^2),   T_n = tanh(lambda_n h).
// In surge q = X [m] and zeta_n = eta_n, the elevation in the tank, with
//   coupling = c_n lambda_n T_n.
// In roll q = theta [rad] and zeta_n = eta_n + c_n theta, the elevation above a plane that stays
// horizontal, so that the tilt of gravity needs no forcing of its own, with
//   coupling = c_n (z0 lambda_n T_n + 1 - 2/cosh(lambda_n h)),
// where z0 is the axis's height above the still surface (derived in linear_roll.hpp).
#pragma once

#include <optional>
#include <vector>

#include "reference/tank.hpp"

namespace slosh::reference {

struct TankMode {
  double wave_number;        // lambda_n [1/m]
  double depth_factor;       // T_n
  double line;               // c_n [m], the mode's coefficient in the sine series of x
  double coupling;           // surge: [-]; roll: [m]
  double natural_frequency;  // omega_n [rad/s]
  double initial_rate;       // zeta_n'(0) [m/s]
};

struct ModeState {
  double elevation;     // zeta_n [m]
  double rate;          // zeta_n' [m/s]
  double acceleration;  // zeta_n'' [m/s2]
};

// Returns the first `count` modes of a surging tank. `initial_velocity` [m/s] is the tank's
// velocity at t = 0 relative to the liquid at rest: X'(0) for a start at rest in the earth's frame,
// 0 for one in the tank's frame. With a gas, the frequencies are those of two-layer theory. Throws
// std::invalid_argument for an impossible tank, gas, velocity or count.
std::vector<TankMode> surge_modes(const Tank& tank, const std::optional<Gas>& gas,
                                  double initial_velocity, int count);

struct RollStart {
  Start start;
  double axis_z;  // [m] above the still surface
  double rate;    // theta'(0) [rad/s]
};

// Returns the first `count` modes of a rolling tank and throws as surge_modes() does. At rest in
// the tank's frame zeta_n'(0) = c_n theta'(0). At rest in the earth's frame the potential vanishes
// on the surface, so that zeta_n'(0) = -coupling theta'(0).
std::vector<TankMode> roll_modes(const Tank& tank, const std::optional<Gas>& gas,
                                 const RollStart& roll, int count);

// Returns sin(lambda_n x), the shape of each mode on the surface.
std::vector<double> surface_shapes(const std::vector<TankMode>& modes, double x);

// cosh(lambda(z+h))/cosh(lambda h) and sinh(lambda(z+h))/cosh(lambda h), in a form that does not
// overflow for z <= 0.
struct DepthProfile {
  double cosh, sinh;
};
DepthProfile depth_profile(double lambda, double z, double depth);

}  // namespace slosh::reference
