// The free standing wave of a viscous liquid with a free surface, let go from rest under
//   eta(x,0) = A cos(k (x + a)),   k = m pi / length,   a = length / 2,
// between side walls and above a bottom on which it slips: the complete solution of the linear
// Navier-Stokes equations, x from the tank's CENTRE. With T = tanh kh, sigma^2 = g k T and
// mu^2 = k^2 + s / nu the Laplace transform of the elevation is
//   eta(s) = A D(s) / (s (D(s) + sigma^2)),
//   D(s)   = (s + 2 nu k^2)^2 - 4 nu^2 k^3 T mu coth(mu h)
// (a potential and a rotational part that both satisfy the bottom; no tangential stress and the
// pressure 2 rho nu w_z on the surface; no vorticity at the start. Prosperetti 1976, 1981 has the
// infinitely deep liquid, where coth = 1). It has no other singularities than the roots s_j of
// D + sigma^2 = 0, so that
//   eta(x,t) = A cos(k(x+a)) sum_j c_j exp(s_j t),   c_j = -sigma^2 / (s_j D'(s_j)):
// the pair -damping +- i omega, which is the wave, and real roots -nu (k^2 + q_n^2),
// n pi < q_n h < (n + 1/2) pi, by which the layer of vorticity under the surface grows. All parts
// together start from A and from rest; the pair alone would start 4.7 % too high at h = 1, g = 1,
// k = pi, nu = 1/50 (0.5 % at 1/250, 0.2 % at 1/500, 0.02 % at 1/2500). For small nu the damping is
// Lamb's 2 nu k^2 (Hydrodynamics, section 348) and omega = sigma, to (nu k^2 / sigma)^(3/2) sigma.
//
// Valid for k A << 1 and 4 nu k^2 <= sigma: the pair becomes two real roots somewhere above
// 2 nu k^2 = sigma, and nothing that sloshes is as viscous.
#pragma once

#include <complex>
#include <span>
#include <vector>

#include "reference/linear_surge.hpp"
#include "reference/standing_wave.hpp"

namespace slosh::reference {

// Positions outside the tank, times before 0 and NaN throw std::invalid_argument, as impossible
// tanks, waves and viscosities do on construction.
class ViscousStandingWave {
 public:
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
  Part<std::complex<double>> pair_;  // and its conjugate
  std::vector<Part<double>> layer_;
};

}  // namespace slosh::reference
