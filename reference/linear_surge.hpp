// Linear potential flow in a rectangular tank that moves horizontally, as a sum over its
// antisymmetric natural modes (Li et al. 2010, eqs 16-20 corrected; Faltinsen 1978; Liu & Lin
// 2008). x is measured from the tank's CENTRE in the tank's frame, z up from the still surface,
// a = length/2:
//   lambda_n = (2n+1) pi / length,  omega_n^2 = g lambda_n tanh(lambda_n h),
//   c_n = 2 (-1)^n / (a lambda_n^2),
//   eta(x,t) = sum_n eta_n(t) sin(lambda_n x),
//   eta_n'' + omega_n^2 eta_n = -(c_n omega_n^2 / g) X''(t).
// With a gas above the liquid omega_n is that of two-layer theory (tank_mode.hpp).
// The theory is valid for waves that are small against the depth and the wave length, and for
// forcing that is not too close to resonance.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "reference/natural_frequency.hpp"
#include "reference/surge_response.hpp"
#include "reference/tank.hpp"

namespace slosh::reference {

// A sine surge is solved in closed form, also at resonance. Every function throws
// std::invalid_argument for NaN and for a position or time outside the liquid at rest or the
// motion's duration; the constructors throw it for an impossible tank, motion or number of modes.
// Use 500 modes or more for an elevation; linear_surge.cpp lists the truncation errors.
class LinearSurge {
 public:
  LinearSurge(const Tank& tank, Start start, const SineSurge& motion, int modes);
  LinearSurge(const Tank& tank, Start start, const AnySurge& motion, int modes);
  // The same with a gas, by two-layer theory. Velocity and pressure remain the liquid's, the
  // pressure above the gas's at the middle of the still surface; the force is that of both.
  LinearSurge(const Tank& tank, const Gas& gas, Start start, const SineSurge& motion, int modes);
  LinearSurge(const Tank& tank, const Gas& gas, Start start, const AnySurge& motion, int modes);
  ~LinearSurge();
  LinearSurge(LinearSurge&&) noexcept;

  // Of x [m] from the tank's centre and z [m] from the still surface.
  double elevation(double x, double t) const;  // [m]
  std::vector<double> elevation(double x, std::span<const double> times) const;
  struct Velocity {
    double x, z;  // [m/s], relative to the tank
  };
  Velocity velocity(double x, double z, double t) const;
  double pressure(double x, double z, double t) const;  // gauge [Pa], hydrostatic part included
  double horizontal_force(double t) const;              // on the tank, per metre of width [N/m]

 private:
  struct Modes;
  std::unique_ptr<const Modes> modes_;
};

}  // namespace slosh::reference
