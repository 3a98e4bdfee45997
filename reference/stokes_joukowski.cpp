#include "reference/stokes_joukowski.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slosh::reference {
namespace {

// At a corner of the liquid the truncation error is the sum of 8 length^2/(pi m)^3 over odd
// m > 4000, which is 4.03e-9 length^2.
constexpr int most_terms = 2000;
// A term below exp(-40) = 4e-18 of the first is left out.
constexpr double negligible_decay = 40;

}  // namespace

StokesJoukowski::StokesJoukowski(const Tank& tank, double axis_x, double axis_z)
    : length_(tank.length), depth_(tank.fill_depth), axis_x_(axis_x), axis_z_(axis_z) {
  const double L = length_, h = depth_, z0 = axis_z_;
  double sum = 0;
  // The terms fall as n^-5, so that the terms after the 500th add less than 1e-13 of the first.
  for (int n = 500; n >= 0; --n) {
    const double lambda = (2 * n + 1) * std::numbers::pi / L;
    sum += 48 * std::tanh(lambda * h / 2) / (L * std::pow(lambda, 5));
  }
  wall_moment_ = -L * h * (h * h / 3 + z0 * h + z0 * z0) + L * L * L * (h / 4 + z0 / 12) -
                 axis_x_ * axis_x_ * L * h - sum;
}

// Of Psi, -x z has the gradient (-z, -x), and the tank's velocity over theta' is (z0 - z, x - X0).
// The difference of the gradient to it is -2 x along z, and the sum.
StokesJoukowski::Flow StokesJoukowski::flow_in_tank(double x, double z) const {
  const double to_surface = std::max(-z, 0.0), to_bottom = std::max(z + depth_, 0.0);
  Flow flow{0, -2 * x};
  for (int n = 0; n < most_terms; ++n) {
    const double lambda = (2 * n + 1) * std::numbers::pi / length_;
    if (lambda * std::min(to_surface, to_bottom) > negligible_decay) break;
    const double c_n = (n % 2 == 0 ? 4 : -4) / (length_ * lambda * lambda);
    const double from_surface = std::exp(-lambda * to_surface),
                 from_bottom = std::exp(-lambda * to_bottom),
                 scale = 2 * c_n / (1 + std::exp(-lambda * depth_));
    flow.x += scale * std::cos(lambda * x) * (from_surface - from_bottom);
    flow.z += scale * std::sin(lambda * x) * (from_surface + from_bottom);
  }
  return flow;
}

double StokesJoukowski::potential(double x, double z) const {
  // The hyperbolic sine over the cosine is written with the distances to the surface and to the
  // bottom, so that no exponential grows.
  const double to_surface = std::max(-z, 0.0), to_bottom = std::max(z + depth_, 0.0);
  double sum = 0;
  for (int n = 0; n < most_terms; ++n) {
    const double lambda = (2 * n + 1) * std::numbers::pi / length_;
    if (lambda * std::min(to_surface, to_bottom) > negligible_decay) break;
    const double c_n = (n % 2 == 0 ? 4 : -4) / (length_ * lambda * lambda);
    const double profile = (std::exp(-lambda * to_surface) - std::exp(-lambda * to_bottom)) /
                           (1 + std::exp(-lambda * depth_));
    sum += 2 * c_n / lambda * std::sin(lambda * x) * profile;
  }
  return axis_z_ * x - axis_x_ * z - x * z + sum;
}

}  // namespace slosh::reference
