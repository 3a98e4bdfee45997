// The antisymmetric natural modes of a moving rectangular tank. x is measured from the tank's
// CENTRE and z up from the still surface. The n-th mode obeys
//   zeta_n'' + omega_n^2 zeta_n = -coupling q''(t),   zeta_n(0) = 0,
//   lambda_n = (2n+1) pi / L,   x = sum c_n sin(lambda_n x) on |x| <= a = L/2,
//   c_n = 2 (-1)^n / (a lambda_n^2),   T_n = tanh(lambda_n h).
// Above the liquid, of density rho_w, is a gas of density rho_a and height h_a, or none: rho_a = 0.
// In surge q = X [m] and zeta_n = eta_n, the elevation in the tank. On the surface, with
// U_n = tanh(lambda_n h_a), the liquid's potential is eta_n'/(lambda_n T_n) and the gas's
// -eta_n'/(lambda_n U_n), and the pressures -rho (phi_t + X'' x + g eta) of both are equal there:
//   D_n eta_n'' + (rho_w - rho_a) (g eta_n + c_n X'') = 0,
//   D_n = rho_w/(lambda_n T_n) + rho_a/(lambda_n U_n),   omega_n^2 = g (rho_w - rho_a)/D_n,
//   coupling = c_n omega_n^2 / g.
// In roll q = theta [rad] and zeta_n = eta_n + c_n theta, the elevation above a plane that stays
// horizontal, so that the tilt of gravity needs no forcing of its own. Each layer also has theta'
// times its own Stokes-Joukowski potential, whose coefficients on the surface are S_n in the liquid
// and R_n in the gas, a rectangle of liquid upside down. With the axis's height z0 above the still
// surface:
//   D_n eta_n'' + (rho_w - rho_a) g zeta_n = -(rho_w S_n - rho_a R_n) theta'',
//   S_n = c_n (z0 + 2 tanh(lambda_n h/2)/lambda_n),  R_n = c_n (z0 - 2 tanh(lambda_n
//   h_a/2)/lambda_n), coupling = (rho_w S_n - rho_a R_n)/D_n - c_n,
// which without a gas is c_n (z0 lambda_n T_n + 1 - 2/cosh(lambda_n h)) (linear_roll.hpp).
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
// 0 for one in the tank's frame. The walls' impulse is continuous across the surface as the
// pressure is, so that eta_n'(0) = -coupling X'(0) with a gas too. Throws std::invalid_argument for
// an impossible tank, gas, velocity or count.
std::vector<TankMode> surge_modes(const Tank& tank, const std::optional<Gas>& gas,
                                  double initial_velocity, int count);

struct RollStart {
  Start start;
  double axis_z;  // [m] above the still surface
  double rate;    // theta'(0) [rad/s]
};

// Returns the first `count` modes of a rolling tank and throws as surge_modes() does. At rest in
// the tank's frame zeta_n'(0) = c_n theta'(0). At rest in the earth's frame rho times the potential
// is continuous across the surface, so that zeta_n'(0) = -coupling theta'(0).
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
