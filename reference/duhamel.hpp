// The modes under any motion q(t), by Duhamel's integral, exact where q'' is linear between its
// samples: over an interval of length s with -coupling q'' = f0 + f1 s,
//   eta(s)  = eta0 cos(w s) + eta0'/w sin(w s) + f0 (1 - cos(w s))/w^2 + f1 (s - sin(w s)/w)/w^2
//   eta'(s) = -w eta0 sin(w s) + eta0' cos(w s) + f0 sin(w s)/w + f1 (1 - cos(w s))/w^2.
// A smooth q'' of angular frequency omega is thus followed to within (omega step)^2/12 of itself.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

#include "reference/tank_mode.hpp"

namespace slosh::reference {

// The tank's displacement [m] or angle [rad] q by its second derivative at 0, step, 2 step, ...
struct SampledMotion {
  std::string_view solution;  // the name that an error gives
  std::function<double(double)> acceleration;
  double duration, step;  // [s]
};

class DuhamelModes {
 public:
  // Samples q'' at 0, step, 2 step, ... and at the duration, and keeps every mode's state there: 16
  // bytes for each mode and sample. Throws std::invalid_argument for a step or duration that is not
  // positive and finite, a step above the duration, or an acceleration that is not finite.
  DuhamelModes(std::vector<TankMode> modes, const SampledMotion& motion);

  double duration() const { return times_.back(); }
  // q''(t) as interpolated, 0 <= t <= duration.
  double acceleration(double t) const;
  // The n-th of the modes given, n from 0, at 0 <= t <= duration.
  ModeState state(std::size_t n, double t) const;

 private:
  struct Node {
    double elevation, rate;
  };

  std::size_t interval(double t) const;
  double slope(std::size_t i) const;

  std::vector<TankMode> modes_;
  double step_;
  std::vector<double> times_, acceleration_;
  std::vector<Node> nodes_;  // sample by sample, each with all modes
};

}  // namespace slosh::reference
