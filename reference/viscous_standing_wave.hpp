// The free standing wave of a viscous liquid released from rest with
//   eta(x,0) = A cos(k (x + a)),   k = m pi / length,   a = length / 2,
// with a free surface and free slip on the side walls and the bottom: the complete solution of the
// linear Navier-Stokes equations. x is measured from the tank's CENTRE. With T = tanh kh,
// sigma^2 = g k T and mu^2 = k^2 + s / nu, the Laplace transform of the elevation is
//   eta(s) = A D(s) / (s (D(s) + sigma^2)),
//   D(s)   = (s + 2 nu k^2)^2 - 4 nu^2 k^3 T mu coth(mu h).
// The flow has a potential and a rotational part that both satisfy the condition on the bottom. On
// the surface the tangential stress is zero and the pressure is 2 rho nu w_z; the flow starts
// without vorticity. (Prosperetti 1976, 1981 solves infinitely deep liquid, where coth = 1.) The
// only singularities of eta(s) are the roots s_j of D + sigma^2 = 0, so that
//   eta(x,t) = A cos(k(x+a)) sum_j c_j exp(s_j t),   c_j = -sigma^2 / (s_j D'(s_j)).
// The pair of roots -damping +- i omega is the wave. The real roots -nu (k^2 + q_n^2), with
// n pi < q_n h < (n + 1/2) pi, describe the growth of the vorticity layer under the surface. The
// sum starts from A and from rest; the pair alone would start 4.7 % too high at h = 1, g = 1,
// k = pi, nu = 1/50 (0.5 % at 1/250, 0.2 % at 1/500, 0.02 % at 1/2500). For small nu the damping is
// Lamb's 2 nu k^2 (Hydrodynamics, section 348) and omega = sigma, to (nu k^2 / sigma)^(3/2) sigma.
//
// The solution is valid for k A << 1 and 4 nu k^2 <= sigma. Somewhere above 2 nu k^2 = sigma the
// pair becomes two real roots; no liquid that sloshes is so viscous.
#pragma once

#include <complex>
#include <span>
#include <vector>

#include "reference/standing_wave.hpp"
#include "reference/tank.hpp"

namespace slosh::reference {

// Every function throws std::invalid_argument for NaN, a position outside the tank and a time
// before 0; the constructor throws it for an impossible tank, wave or viscosity.
class ViscousStandingWave {
 public:
  // `kinematic_viscosity` is in [m2/s].
  ViscousStandingWave(const Tank& tank, double kinematic_viscosity, const InitialWave& wave);

  double damping() const { return -pair_.rate.real(); }           // [1/s]
  double angular_frequency() const { return pair_.rate.imag(); }  // [rad/s]
  double elevation(double x, double t) const;                     // [m]
  std::vector<double> elevation(double x, std::span<const double> times) const;

 private:
  template <class Number>
  struct Part {
    Number rate, share;  // s_j [1/s], c_j
  };
  double relative_height(double t) const;

  Tank tank_;
  InitialWave wave_;
  Part<std::complex<double>> pair_;  // one root; its complex conjugate is the other
  std::vector<Part<double>> layer_;
};

}  // namespace slosh::reference
