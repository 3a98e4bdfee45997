// The equations of fully nonlinear potential flow in a tank that moves as a rigid body, in the
// tank's frame (tank_motion.hpp). Phi is the potential of the velocity against the earth, (u, w) =
// grad Phi along the tank's axes, phi(x,t) = Phi(x, eta(x,t), t):
//   walls    dPhi/dn = u_tank . n
//   surface  eta_t = w - w_tank - (u - u_tank) eta_x
//            phi_t = u_tank . grad Phi - |grad Phi|^2/2 - g Z + w eta_t
//   within   p/rho = u_tank . grad Phi - |grad Phi|^2/2 - g Z - Phi_t,
// where Phi_t, at a point fixed in the tank, is harmonic too: phi_t - w eta_t on the surface and
// the walls' acceleration normal to them (Faltinsen & Timokha, Sloshing, 2009, chapter 2;
// Zakharov's surface form). The flow is Hamiltonian: with
//   H = integral over the liquid of |grad Phi|^2/2 - u_tank . grad Phi + g Z
// dH/dt is what the time that stands in u_tank and Z gives:
//   dH/dt = integral over the liquid of -u_tank_t . grad Phi + g Z_t,
// the balance of the energy against the earth, less the walls' work, and of the momentum and its
// moment in one. Of g Z the part above the still surface counts, eta of mean zero:
//   integral over x of g (x eta sin(theta) + eta^2/2 cos(theta)).
// Inviscid, irrotational, one value of eta at each x, no surface tension.
#pragma once

#include <Eigen/Dense>

#include "reference/linear_surge.hpp"
#include "reference/mapped_laplace.hpp"
#include "reference/tank_motion.hpp"

namespace slosh::reference {

class FreeSurfaceFlow {
 public:
  FreeSurfaceFlow(const Tank& tank, const TankMotion& motion, int nodes_x, int nodes_z);

  const LegendreGrid& x() const { return laplace_.x(); }
  const LegendreGrid& s() const { return laplace_.s(); }  // [0, 1], bottom to surface

  struct State {
    Eigen::VectorXd elevation, potential;  // eta [m] and phi [m2/s] at the x nodes
  };

  // All that follow throw NoLaplaceSolution where mapped_laplace.hpp says so.
  struct Rates {
    Eigen::VectorXd elevation, potential;  // eta_t [m/s], phi_t [m2/s2]
    double energy, energy_rate;            // H [m4/s2] and dH/dt, per density and width
  };
  Rates rates(const State& state, double t);

  // phi for which the surface keeps its shape in the tank, eta_t = 0: the liquid at rest in the
  // tank as nearly as a potential flow can be.
  Eigen::VectorXd potential_at_rest_in_tank(const Eigen::VectorXd& elevation, double t);

  struct Pressure {
    Eigen::MatrixXd field;   // above the gas's [Pa], [nodes_x x nodes_z]
    Eigen::VectorXd column;  // the liquid's depth D at the x nodes [m]
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
  Eigen::MatrixXd guess_, guess_rate_;  // the last solutions, to start the next from
};

}  // namespace slosh::reference
