// The free standing wave of linear potential flow when the liquid is released from rest with
//   eta(x,0) = A cos(k (x + a)),   k = m pi / length,   m = 1, 2, ...,   a = length / 2.
// x is measured from the tank's CENTRE, z up from the still surface (Lamb, Hydrodynamics, section
// 228):
//   eta = A cos(k(x+a)) cos(omega t),   omega^2 = g k tanh kh, or that of two-layer theory
//   phi_t = -A omega^2 cos(k(x+a)) cosh(k(z+h)) / (k sinh kh) cos(omega t)
//   velocity  grad phi,  phi = -A omega cos(k(x+a)) cosh(k(z+h)) / (k sinh kh) sin(omega t)
//   pressure  p = -rho (g z + phi_t)
//   force     F = integral over -h < z < 0 of p(a,z) - p(-a,z)
//               = rho A omega^2 cos(omega t) ((-1)^m - 1) / k^2; with a gas that of both, with
//                 rho less the gas's density in place of rho
// The solution is valid for k A << 1: in deep liquid a finite amplitude lowers the frequency by the
// fraction (k A)^2 / 8 (Tadjbakhsh & Keller 1960). It superposes on the response to the tank's
// motion (linear_surge.hpp, linear_roll.hpp).
#pragma once

#include <optional>

#include "reference/natural_frequency.hpp"
#include "reference/tank.hpp"

namespace slosh::reference {

struct InitialWave {
  int mode;          // m, the number of half waves between the walls
  double amplitude;  // A [m]; positive with the crest at the left wall
};

// Every function throws std::invalid_argument for NaN, a position outside the liquid at rest and a
// time before 0; the constructor throws it for an impossible tank, gas or wave.
class StandingWave {
 public:
  // With a gas, the frequency is that of two-layer theory.
  StandingWave(const Tank& tank, const std::optional<Gas>& gas, const InitialWave& wave);

  double angular_frequency() const { return angular_frequency_; }  // [rad/s]
  // Of x [m] from the tank's centre and z [m] from the still surface.
  double elevation(double x, double t) const;  // [m]
  struct Velocity {
    double x, z;  // [m/s]
  };
  Velocity velocity(double x, double z, double t) const;
  double pressure(double x, double z, double t) const;  // gauge [Pa], hydrostatic part included
  double horizontal_force(double t) const;              // on the tank, per metre of width [N/m]

 private:
  double acceleration(double t) const;  // omega^2 A cos(omega t) [m/s2]

  Tank tank_;
  InitialWave wave_;
  double wave_number_, angular_frequency_;
  double density_difference_;  // of liquid and gas [kg/m3]
};

// Returns cos(k (x + a)) at x [m] from the tank's centre. Throws std::invalid_argument unless x
// lies between the tank's walls.
double mode_shape(const Tank& tank, int mode, double x);

}  // namespace slosh::reference
