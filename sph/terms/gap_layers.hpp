// The boundary layers on the gap walls of a narrow tank, the gap b apart. In a
// laminar flow between them with the mean velocity v over the gap, the walls' stress slows the
// liquid down by the force per mass (Landau & Lifshitz 1987, section 24, problem 6, in Laplace's
// variable s)
//   W(s) v = s v (tanh k / k) / (1 - tanh k / k),   k = (b / 2) sqrt(s / nu)
// The poles of W are at k = i y_n with tan y_n = y_n > 0, and the sum over them is exact:
//   W(s) = 12 nu / b^2 + sum_n (8 nu / b^2) s / (s + rate_n),   rate_n = 4 nu y_n^2 / b^2
// The first term is the friction of Poiseuille flow. Each other term is a layer with a velocity m_n
// that follows that of the liquid:
//   force = (8 nu / b^2) (v - m_n),   dm_n/dt = rate_n (v - m_n)
// A slow flow feels the layers as an added mass, sum_n 2 / y_n^2 = 1/5 of the liquid's, and a quick
// one as the friction of two Stokes layers, (2 / b) sqrt(nu s).
//
// The layers 1, 2, 3 to 4, 5 to 8, 9 to 16, ... each share one velocity, at the rate that keeps
// their added mass. W(i omega) is then within 2 % of the sum.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "sph/setting.hpp"

namespace slosh::sph {

// A group of layers with one velocity.
struct GapLayer {
  double friction;  // [1/s] of the difference of its velocity and the liquid's
  double rate;      // [1/s] at which its velocity follows the liquid's
};

struct GapLayers {
  double steady_friction = 0;  // [1/s], of Poiseuille flow
  std::vector<GapLayer> layers = {};

  // The friction of a velocity that has begun suddenly [1/s].
  double largest_friction() const {
    double sum = steady_friction;
    for (const GapLayer& layer : layers) sum += layer.friction;
    return sum;
  }
};

// Their last group is 2^14 times as quick as the slowest one.
inline constexpr int most_gap_layers = 16;

// Returns y_n, the n-th positive solution of tan y = y.
inline double layer_root(int n) {
  double y = (n + 0.5) * std::numbers::pi;
  for (int i = 0; i < 40; ++i) y = n * std::numbers::pi + std::atan(y);
  return y;
}

// Returns the layers that follow a velocity at rates below `fastest` [1/s], at least the first and
// at most most_gap_layers.
inline GapLayers gap_layers(double breadth, double kinematic_viscosity, double fastest) {
  const double unit = 4 * kinematic_viscosity / (breadth * breadth);
  GapLayers result{.steady_friction = 3 * unit};
  int first = 1, last = 1;
  for (int n = 0; n < most_gap_layers; ++n, first = last + 1, last *= 2) {
    if (n > 0 && result.layers.back().rate > fastest) break;
    double added_mass = 0;
    for (int k = first; k <= last; ++k) added_mass += 2 / std::pow(layer_root(k), 2);
    const double friction = 2 * unit * (last - first + 1);
    result.layers.push_back({friction, friction / added_mass});
  }
  return result;
}

// Returns the layers of a scheme's scene that follow at rates below c0 / h. There is none where the
// scene has no breadth or no viscosity.
inline GapLayers gap_layers(const Setting& s) {
  if (s.breadth == 0 || s.kinematic_viscosity == 0) return {};
  return gap_layers(s.breadth, s.kinematic_viscosity, s.speed_of_sound / s.smoothing_length());
}

}  // namespace slosh::sph
