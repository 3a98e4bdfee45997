// The Stokes-Joukowski potential Psi of a rectangle of liquid that turns about an axis at (X0, z0):
// theta' Psi is the flow in the earth's frame when the walls, the bottom and a lid on the still
// surface all turn together. x is measured from the tank's centre, z from the still surface;
// a = length/2:
//   Psi_xx + Psi_zz = 0,  Psi_x = -(z - z0) on x = +-a,  Psi_z = x - X0 on z = 0 and z = -h,
//   Psi = z0 x - X0 z - x z + sum 2 c_n sin(lambda_n x)
//         sinh(lambda_n(z + h/2)) / (lambda_n cosh(lambda_n h/2)),
//   lambda_n = (2n+1) pi / length,  c_n = 2 (-1)^n / (a lambda_n^2),  x = sum c_n sin(lambda_n x).
// The first three terms satisfy the condition on the side walls, on which the sum has no normal
// velocity. On z = 0 and z = -h the sum adds the 2 x that -x z lacks (Faltinsen & Timokha,
// Sloshing, 2009, chapter 5, give the theory). Its terms fall as n^-3 on the surface and the
// bottom, and as exp(-lambda_n distance) inside.
#pragma once

#include "reference/tank.hpp"

namespace slosh::reference {

class StokesJoukowski {
 public:
  // The tank's length and depth must be positive and finite, and the axis finite.
  StokesJoukowski(const Tank& tank, double axis_x, double axis_z);

  // Returns Psi(x, z) [m2] in the liquid at rest, x from the tank's centre; it is zero at x = z =
  // 0. The truncation error is at most 4.1e-9 length^2, in the four corners; further than 0.0032
  // length from the surface and the bottom it is below rounding.
  double potential(double x, double z) const;

  // Returns grad Psi [m] less the velocity of the turning tank over theta', (-(z - z0), x - X0):
  // the flow relative to the tank. It is truncated as the potential is; its terms fall as n^-2 on
  // the surface and the bottom.
  struct Flow {
    double x, z;
  };
  Flow flow_in_tank(double x, double z) const;

  // Returns the moment about the axis of the pressure -rho theta'' Psi on the walls and the bottom,
  // without the lid, divided by rho theta'' [m4]. It is negative, as it opposes the acceleration.
  // With tau_n = tanh(lambda_n h/2):
  //   -length integral (z - z0)^2 dz + length^3 (h/4 + z0/12) - X0^2 length h
  //   - sum 48 tau_n / (length lambda_n^5).
  double wall_moment() const { return wall_moment_; }

 private:
  double length_, depth_, axis_x_, axis_z_;
  double wall_moment_;
};

}  // namespace slosh::reference
