// The length of a time step.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <variant>

#include "sph/setting.hpp"
#include "sph/terms/gap_layers.hpp"

namespace slosh::sph {

// The most that the friction of the gap walls may take of a velocity in a step
// (terms/gap_friction.hpp).
inline constexpr double largest_friction_per_step = 0.1;

// The 0.5 ms of Li et al. 2010, at every spacing.
struct FixedStep {
  static constexpr bool adapts = false;
  static constexpr double step = 5e-4;  // [s]
  // Limit of the Courant number dt c0 / h. With alpha = 1 on a surge, the motion was measured to be
  // unchanged up to 1.1, noisy from 1.2 and divergent at 1.4; the limit keeps a margin.
  static constexpr double stable_courant_number = 0.65;

  explicit FixedStep(const Setting& s) {
    if (const double friction = gap_layers(s).largest_friction();
        friction * step > largest_friction_per_step)
      throw std::invalid_argument(
          fmt::format("breadth = {:.4g} m, where the friction of the gap walls is {:.4g} 1/s: "
                      "expected at most {:.4g} 1/s with the scheme's fixed time step",
                      s.breadth, friction, largest_friction_per_step / step));
  }
  double operator()(double, double) const { return step; }
};

// dt = min(C h / c, 0.25 sqrt(h / |a|), 0.0625 h^2 / nu): Courant, force and viscous criterion
// (Monaghan 1992, section 10.3; Morris, Fox & Zhu 1997, eq. 21), where c is the speed of sound of
// the densest particle, at least c0, a is the largest acceleration [m/s2], and nu is the larger of
// the liquid's viscosity and the artificial one's alpha h c0 / 8. The viscous number of Morris, Fox
// & Zhu is 0.125. On a square lattice the largest eigenvalue of the pair sum is 24.1 nu / h^2
// (Kaiser-Bessel, h = 1.5 dp; quintic 23.1), with which an explicit step is stable up to 0.083 h^2
// / nu. With the quintic the wave of Re = 50 at 10 mm was unstable at 0.107 together with a Courant
// number of 0.8. The friction of gap walls limits the step too.
struct AdaptiveStep {
  static constexpr bool adapts = true;
  static constexpr double viscous_number = 0.0625;  // nu dt / h^2
  double longest_step, courant_number, h;

  explicit AdaptiveStep(const Setting& s)
      : longest_step(s.courant_number * s.smoothing_length() / s.speed_of_sound),
        courant_number(s.courant_number),
        h(s.smoothing_length()) {
    const double nu =
        std::max(s.kinematic_viscosity, s.artificial_viscosity * h * s.speed_of_sound / 8);
    if (nu > 0) longest_step = std::min(longest_step, viscous_number * h * h / nu);
    if (const double friction = gap_layers(s).largest_friction(); friction > 0)
      longest_step = std::min(longest_step, largest_friction_per_step / friction);
  }
  double operator()(double largest_acceleration, double largest_speed_of_sound) const {
    return std::min({longest_step, courant_number * h / largest_speed_of_sound,
                     0.25 * std::sqrt(h / largest_acceleration)});
  }
};

using TimeStep = std::variant<FixedStep, AdaptiveStep>;

}  // namespace slosh::sph
