// How long a step may be.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "sph/setting.hpp"

namespace slosh::sph {

// The 0.5 ms of Li et al. 2010, whatever the spacing.
struct FixedStep {
  static constexpr bool adapts = false;
  static constexpr double step = 5e-4;  // [s]
  // Courant number dt c0 / h. Measured with alpha = 1 on a surge: the same motion up to 1.1, noise
  // from 1.2, divergence at 1.4. The limit keeps a margin to that.
  static constexpr double stable_courant_number = 0.65;

  explicit FixedStep(const Setting&) {}
  double operator()(double) const { return step; }
};

// dt = min(C h / c0, 0.25 sqrt(h / |a|)): Courant and force criterion (Monaghan 1992, section
// 10.3), a the largest acceleration [m/s2].
struct AdaptiveStep {
  static constexpr bool adapts = true;
  double courant_step, h;

  explicit AdaptiveStep(const Setting& s)
      : courant_step(s.courant_number * s.smoothing_length() / s.speed_of_sound),
        h(s.smoothing_length()) {}
  double operator()(double largest_acceleration) const {
    return std::min(courant_step, 0.25 * std::sqrt(h / largest_acceleration));
  }
};

}  // namespace slosh::sph
