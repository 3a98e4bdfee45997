// Linear potential flow in a rectangular tank that rolls by a small angle theta(t),
// counter-clockwise with x to the right and z up, about an axis fixed in the earth's frame and in
// the tank's at (X0, z0). x from the tank's CENTRE in the tank's frame, z up from the still surface
// in that frame, a = length/2. The flow in the earth's frame has the potential
//   Phi = theta' Psi(x,z) + sum p_n sin(lambda_n x) cosh(lambda_n(z+h))/cosh(lambda_n h),
// Psi the Stokes-Joukowski potential (stokes_joukowski.hpp), so that on z = 0
//   kinematics   eta_n' = lambda_n T_n p_n,                    T_n = tanh(lambda_n h)
//   no pressure  p_n' = -g (eta_n + c_n theta) - theta'' S_n,  S_n of Psi(x,0) = sum S_n sin,
//   S_n = c_n (z0 + 2 tanh(lambda_n h/2)/lambda_n),            x = sum c_n sin(lambda_n x).
// In zeta_n = eta_n + c_n theta, the elevation above the level plane, this is
//   zeta_n'' + omega_n^2 zeta_n = -(lambda_n T_n S_n - c_n) theta'',
//   lambda_n T_n S_n - c_n = c_n (z0 lambda_n T_n + 1 - 2/cosh(lambda_n h)),
//   eta(x,t) = -x theta + sum zeta_n sin(lambda_n x):
// gravity's tilt needs no series, and a slow roll leaves a level surface, term by term. An axis off
// the centre line heaves the tank too: that changes the pressure, not the elevation.
// Derived here; Faltinsen & Timokha, Sloshing (2009), chapter 5, give the general linear theory.
// Valid for small theta and waves small as in linear_surge.hpp.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "reference/linear_surge.hpp"

namespace slosh::reference {

struct RollMotion {
  std::function<double(double)> angle, rate, acceleration;  // theta and its derivatives, rad, s
  double axis_x, axis_z;  // [m]: X0 from the tank's centre, z0 above the still surface
  double duration, step;  // [s]; theta'' is taken linear between 0, step, 2 step, ...
};

// The liquid starts with a level surface, eta = -x theta(0), and at rest: in the earth's frame (the
// walls are set off at theta'(0)) or in the tank. Positions and times outside the liquid at rest,
// or outside the motion's duration, and NaN throw std::invalid_argument, as impossible tanks,
// motions and numbers of modes do on construction. It keeps 16 bytes for each mode and step.
class LinearRoll {
 public:
  LinearRoll(const Tank& tank, Start start, const RollMotion& motion, int modes);
  // The same with the frequencies (not the couplings) of the two-layer theory.
  LinearRoll(const Tank& tank, const Gas& gas, Start start, const RollMotion& motion, int modes);
  ~LinearRoll();
  LinearRoll(LinearRoll&&) noexcept;

  // eta [m] above the still surface of the tank and normal to it, in the tank's frame.
  double elevation(double x, double t) const;
  std::vector<double> elevation(double x, std::span<const double> times) const;

  // [Pa] above the gas's, at a place fixed in the tank, -h <= z <= 0:
  //   -rho (g z + g theta x + theta'' Psi(x,z) + sum p_n' sin(lambda_n x) C_n(z)),
  //   C_n = cosh(lambda_n(z+h))/cosh(lambda_n h),
  // hydrostatic part, gravity's tilt about the tank's centre (the height of the centre itself,
  // -X0 theta, changes no pressure), walls' acceleration (in Psi: -x z and its series, z0 x of the
  // centre's surge, -X0 z of its heave), waves. The terms of the second order, among them the
  // centrifugal rho theta'^2 r^2/2 and the velocity's square, are left out.
  double pressure(double x, double z, double t) const;
  // For a series at one place; its modes' shapes are computed once, and those that do not reach
  // down to z left out.
  std::vector<double> pressure(double x, double z, std::span<const double> times) const;

  // Of the liquid on the tank, by the pressure on the walls and the bottom up to the still surface;
  // what the wave wets or bares at a wall is of the second order. Static part included: the weight
  // rho g length h in z, and what gravity's tilt adds to x. [N/m], along the tank's axes, per metre
  // of width.
  struct Force {
    double x, z;
  };
  Force force(double t) const;
  // Likewise about the axis, counter-clockwise positive, per metre of width [N].
  double moment(double t) const;

 private:
  struct Modes;
  std::unique_ptr<const Modes> modes_;
};

}  // namespace slosh::reference
