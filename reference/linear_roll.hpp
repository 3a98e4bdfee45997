// Linear potential flow in a rectangular tank that rolls by a small angle theta(t), positive
// counter-clockwise with x to the right and z up. The axis at (X0, z0) is fixed both in the earth's
// frame and in the tank's. x is measured from the tank's CENTRE and z up from the still surface,
// both in the tank's frame; a = length/2. In the earth's frame the flow has the potential
//   Phi = theta' Psi(x,z) + sum p_n sin(lambda_n x) cosh(lambda_n(z+h))/cosh(lambda_n h),
// where Psi is the Stokes-Joukowski potential (stokes_joukowski.hpp). On z = 0 this gives
//   kinematics   eta_n' = lambda_n T_n p_n,                    T_n = tanh(lambda_n h)
//   no pressure  p_n' = -g (eta_n + c_n theta) - theta'' S_n,  S_n of Psi(x,0) = sum S_n sin,
//   S_n = c_n (z0 + 2 tanh(lambda_n h/2)/lambda_n),            x = sum c_n sin(lambda_n x).
// For zeta_n = eta_n + c_n theta, the elevation above a horizontal plane, it follows that
//   zeta_n'' + omega_n^2 zeta_n = -(lambda_n T_n S_n - c_n) theta'',
//   lambda_n T_n S_n - c_n = c_n (z0 lambda_n T_n + 1 - 2/cosh(lambda_n h)),
//   eta(x,t) = -x theta + sum zeta_n sin(lambda_n x).
// With a gas above the liquid the kinematics are the same, and tank_mode.hpp gives omega_n and what
// stands before theta''. The tilt of gravity thus needs no series, and in a slow roll every term
// leaves the surface horizontal. An axis off the centre line also heaves the tank, which changes
// the pressure and not the elevation. The equations are derived here; Faltinsen & Timokha, Sloshing
// (2009), chapter 5, give the general linear theory. They are valid for small theta and for waves
// that are small as in linear_surge.hpp.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "reference/tank.hpp"

namespace slosh::reference {

struct RollMotion {
  std::function<double(double)> angle, rate, acceleration;  // theta and its derivatives, rad, s
  double axis_x, axis_z;  // [m]: X0 from the tank's centre, z0 above the still surface
  double duration, step;  // [s]; theta'' is linear between the samples at 0, step, 2 step, ...
  std::vector<double> knots = {};  // [s] or at these, rising from 0 to the duration
};

// At the start the surface is horizontal, eta = -x theta(0), and the liquid is at rest in the
// earth's frame, in which the walls move off at theta'(0), or in the tank's. Every function throws
// std::invalid_argument for NaN and for a position or time outside the liquid at rest or the
// motion's duration; the constructors throw it for an impossible tank, motion or number of modes.
// An object takes 16 bytes of memory for each mode and step.
class LinearRoll {
 public:
  LinearRoll(const Tank& tank, Start start, const RollMotion& motion, int modes);
  // The same with a gas, by two-layer theory. Velocity and pressure remain the liquid's; force and
  // moment are those of both.
  LinearRoll(const Tank& tank, const Gas& gas, Start start, const RollMotion& motion, int modes);
  ~LinearRoll();
  LinearRoll(LinearRoll&&) noexcept;

  // Returns eta [m], the height above the still surface of the tank and normal to it, in the tank's
  // frame, at x [m] from the tank's centre.
  double elevation(double x, double t) const;
  std::vector<double> elevation(double x, std::span<const double> times) const;

  // Returns the pressure [Pa] above the gas's at the middle of the still surface, at a place fixed
  // in the tank, x [m] from its centre and z [m] from the still surface, -h <= z <= 0:
  //   -rho (g z + g theta x + theta'' Psi(x,z) + sum p_n' sin(lambda_n x) C_n(z)),
  //   C_n = cosh(lambda_n(z+h))/cosh(lambda_n h).
  // The terms are the hydrostatic part, the tilt of gravity about the tank's centre (the centre's
  // own height, -X0 theta, changes no pressure), the walls' acceleration (of which Psi contains
  // -x z and its series, z0 x of the centre's surge and -X0 z of its heave), and the waves. Terms
  // of second order, among them the centrifugal rho theta'^2 r^2/2 and the square of the velocity,
  // are left out.
  double pressure(double x, double z, double t) const;
  // For a series at one place the modes' shapes are computed once, and modes that do not reach down
  // to z are left out.
  std::vector<double> pressure(double x, double z, std::span<const double> times) const;

  // Returns the force on the tank along the tank's axes, per metre of width [N/m]. It integrates
  // the pressure of the liquid on the walls and the bottom up to the still surface, and that of a
  // gas on the walls and the roof; what the wave adds is of second order. The static part is
  // included: the weight, rho g length h of the liquid, in z, and what the tilt of gravity adds in
  // x.
  struct Force {
    double x, z;
  };
  Force force(double t) const;

  // Returns the velocity relative to the tank, along its axes: theta' times the flow relative to a
  // tank that turns under a lid (stokes_joukowski.hpp), and the gradient of the waves. x and z as
  // for the pressure.
  struct Velocity {
    double x, z;  // [m/s]
  };
  Velocity velocity(double x, double z, double t) const;

  // Returns the moment of the same pressure about the axis, counter-clockwise positive, per metre
  // of width [N].
  double moment(double t) const;

 private:
  struct Modes;
  std::unique_ptr<const Modes> modes_;
};

}  // namespace slosh::reference
