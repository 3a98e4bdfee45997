// The free standing wave that linear potential flow makes of a liquid let go from rest under
//   eta(x,0) = A cos(k (x + a)),   k = m pi / length,   m = 1, 2, ...,   a = length / 2,
// x from the tank's CENTRE, z up from the still surface (Lamb, Hydrodynamics, section 228):
//   eta = A cos(k(x+a)) cos(omega t),   omega^2 = g k tanh kh, or that of the two-layer theory
//   phi_t = -A omega^2 cos(k(x+a)) cosh(k(z+h)) / (k sinh kh) cos(omega t)
//   pressure  p = -rho (g z + phi_t)
//   force     F = integral over -h < z < 0 of p(a,z) - p(-a,z)
//               = rho A omega^2 cos(omega t) ((-1)^m - 1) / k^2
// Valid for k A << 1: a wave of finite amplitude is slower in deep liquid by the share (k A)^2 / 8
// (Tadjbakhsh & Keller 1960). It adds to what the tank's motion does (linear_surge.hpp,
// linear_roll.hpp).
#pragma once

#include <optional>

#include "reference/linear_surge.hpp"

namespace slosh::reference {

// Half waves between the walls, and the height of its crest at the left wall, or of its trough
// where negative [m].
struct InitialWave {
  int mode;
  double amplitude;
};

// Positions outside the liquid at rest, times before 0 and NaN throw std::invalid_argument, as
// impossible tanks, gases and waves do on construction.
class StandingWave {
 public:
  // With a gas, the frequency is that of the two-layer theory.
  StandingWave(const Tank& tank, const std::optional<Gas>& gas, const InitialWave& wave);

  double angular_frequency() const { return angular_frequency_; }  // [rad/s]
  double elevation(double x, double t) const;                      // [m]
  double pressure(double x, double z, double t) const;  // gauge [Pa], hydrostatic part included
  double horizontal_force(double t) const;  // of the liquid on the tank, per metre of width [N/m]

 private:
  double acceleration(double t) const;  // omega^2 A cos(omega t) [m/s2]

  Tank tank_;
  InitialWave wave_;
  double wave_number_, angular_frequency_;
};

// cos(k (x + a)) of a mode of the tank at x, which lies between its walls.
double mode_shape(const Tank& tank, int mode, double x);

}  // namespace slosh::reference
