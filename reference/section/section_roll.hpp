// Linear potential flow in a tank of any polygonal section that turns by a small angle theta(t),
// positive counter-clockwise, about an axis (x0, z0) that is fixed in the earth's frame and in the
// tank's. With the outline's coordinates, the modes and potentials of section_flow.hpp and the
// surface's middle (xm, h), the flow has in the earth's frame the potential
//   Phi = theta' Psi_0 + sum p_n phi_n,  Psi_0 = Psi + (z0-h)(x-xm) - (x0-xm)(z-h),
// and on the surface, for eta = sum e_n phi_n and S_n = <Psi_0, phi_n>,
//   kinematics   e_n' = kappa_n p_n
//   no pressure  p_n' = -g (e_n + <x, phi_n> theta) - theta'' S_n.
// For the elevation above a horizontal plane, zeta_n = e_n + <x, phi_n> theta, it follows that
//   zeta_n'' + omega_n^2 zeta_n = -c_n theta'',  c_n = kappa_n S_n - <x, phi_n>.
// What follows theta'' at once is summed over all modes in closed form, as in section_surge.hpp:
//   W = sum zeta_n phi_n = -theta''/g (lid + (z0-h) chi - lifted_line)
//                          - sum zeta_n''/omega_n^2 phi_n
//   elevation  eta = -theta (x-xm) + W
//   pressure   p = -rho (g (z-h) + g theta (x-xm) - g W
//                        + theta'' (Psi - lid + (z0-h)(x-xm-chi) - (x0-xm)(z-h)))
//   velocity   theta' (grad(Psi - lifted_line) - (-(z-h), x-xm)) + sum zeta_n'/kappa_n grad phi_n
// The force and the moment are the pressure's on the walls up to the still surface; by Green's
// theorem they need no integral along a wall. For a rectangle this is linear_roll.hpp, whose limits
// of validity it shares; the equations are derived here.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "reference/section/section_modes.hpp"
#include "reference/tank.hpp"

namespace slosh::reference {

struct SectionRollMotion {
  std::function<double(double)> angle, rate, acceleration;  // theta and its derivatives, rad, s
  Corner axis;            // (x0, z0) in the OUTLINE'S coordinates [m]
  double duration, step;  // [s]; theta'' is linear between the samples at 0, step, 2 step, ...
  std::vector<double> knots = {};  // [s] or at these, rising from 0 to the duration
};

// At the start the surface is horizontal, eta = -theta(0) (x - xm), and the liquid is at rest in
// the earth's frame or in the tank's. Every function throws std::invalid_argument for NaN and for a
// position or time outside the liquid at rest or the motion's duration; the constructor throws it
// for an impossible motion.
class SectionRoll {
 public:
  SectionRoll(const SectionModes& modes, Start start, const SectionRollMotion& motion);
  ~SectionRoll();
  SectionRoll(SectionRoll&&) noexcept;

  // The height above the tank's still surface and normal to it [m].
  double elevation(double x, double t) const;
  std::vector<double> elevation(double x, std::span<const double> times) const;
  struct Velocity {
    double x, z;  // [m/s], relative to the tank and along its axes
  };
  Velocity velocity(double x, double z, double t) const;
  double pressure(double x, double z, double t) const;  // gauge [Pa], hydrostatic part included
  std::vector<double> pressure(double x, double z, std::span<const double> times) const;

  // Of the liquid on the tank along the tank's axes, per metre of width [N/m], weight included.
  struct Force {
    double x, z;
  };
  Force force(double t) const;
  // Of the same pressure about the axis, counter-clockwise positive, per metre of width [N].
  double moment(double t) const;

 private:
  struct Waves;
  std::unique_ptr<const Waves> waves_;
};

}  // namespace slosh::reference
