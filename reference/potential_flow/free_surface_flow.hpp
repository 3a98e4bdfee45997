// The equations of fully nonlinear potential flow in a tank that moves as a rigid body, in the
// tank's frame (tank_motion.hpp). Phi is the potential of the velocity in the earth's frame,
// (u, w) = grad Phi along the tank's axes, and phi(x,t) = Phi(x, eta(x,t), t):
//   walls    dPhi/dn = u_tank . n
//   surface  eta_t = w - w_tank - (u - u_tank) eta_x
//            phi_t = u_tank . grad Phi - |grad Phi|^2/2 - g Z + w eta_t
//   within   p/rho = u_tank . grad Phi - |grad Phi|^2/2 - g Z - Phi_t.
// At a point fixed in the tank Phi_t is harmonic too. Its value on the surface is phi_t - w eta_t,
// and its normal derivative on the walls is their normal acceleration (Faltinsen & Timokha,
// Sloshing, 2009, chapter 2; Zakharov's surface form). The flow is Hamiltonian with
//   H = integral over the liquid of |grad Phi|^2/2 - u_tank . grad Phi + g Z.
// H changes only through the explicit time dependence of u_tank and Z:
//   dH/dt = integral over the liquid of -u_tank_t . grad Phi + g Z_t.
// This is the energy balance in the earth's frame less the walls' work, together with the balance
// of momentum and its moment. Of g Z only the part above the still surface is counted, with eta of
// mean zero:
//   integral over x of g (x eta sin(theta) + eta^2/2 cos(theta)).
// The flow is inviscid and irrotational, eta is a function of x, and there is no surface tension.
#pragma once

#include <Eigen/Core>

#include "reference/potential_flow/mapped_laplace.hpp"
#include "reference/potential_flow/tank_motion.hpp"
#include "reference/tank.hpp"

namespace slosh::reference {

class FreeSurfaceFlow {
 public:
  FreeSurfaceFlow(const Tank& tank, const TankMotion& motion, int nodes_x, int nodes_z);

  const LegendreGrid& x() const { return laplace_.x(); }
  const LegendreGrid& s() const { return laplace_.s(); }  // [0, 1], bottom to surface

  struct State {
    Eigen::VectorXd elevation, potential;  // eta [m] and phi [m2/s] at the x nodes
  };

  // The functions below throw NoLaplaceSolution as mapped_laplace.hpp describes.
  struct Rates {
    Eigen::VectorXd elevation, potential;  // eta_t [m/s], phi_t [m2/s2]
    double energy, energy_rate;            // H [m4/s2] and dH/dt, per density and width
  };
  Rates rates(const State& state, double t);

  // Returns the phi for which the surface keeps its shape in the tank, eta_t = 0. It is the
  // potential flow that comes closest to a liquid at rest in the tank.
  Eigen::VectorXd potential_at_rest_in_tank(const Eigen::VectorXd& elevation, double t);

  struct Pressure {
    Eigen::MatrixXd field;             // [Pa] above the gas's, [nodes_x x nodes_z]
    Eigen::VectorXd column;            // the liquid's depth D at the x nodes [m]
    MappedLaplace::Gradient velocity;  // relative to the tank [m/s]
    WallLoad load;
  };
  Pressure pressure(const State& state, double t);

 private:
  struct Flow;
  Flow solve(const State& state, double t);
  Eigen::ArrayXd potential_rate(const Flow& flow, const State& state) const;
  MappedLaplace::WallData on_walls(const RigidField& rigid) const;

  Tank tank_;
  TankMotion motion_;
  MappedLaplace laplace_;
  Eigen::MatrixXd guess_, guess_rate_;  // the last solutions, initial guesses for the next
};

}  // namespace slosh::reference
