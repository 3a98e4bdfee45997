// The modes under any motion X(t), by Duhamel's integral, exact where X'' is linear between its
// samples: over an interval of length s with -coupling X'' = f0 + f1 s,
//   eta(s)  = eta0 cos(w s) + eta0'/w sin(w s) + f0 (1 - cos(w s))/w^2 + f1 (s - sin(w s)/w)/w^2
//   eta'(s) = -w eta0 sin(w s) + eta0' cos(w s) + f0 sin(w s)/w + f1 (1 - cos(w s))/w^2.
// A smooth X'' of angular frequency omega is thus followed to within (omega step)^2/12 of itself.
#pragma once

#include <cstddef>
#include <vector>

#include "reference/surge_mode.hpp"

namespace slosh::reference {

class DuhamelModes {
 public:
  // Samples X'' at 0, step, 2 step, ... and at the duration, and keeps every mode's state there: 16
  // bytes for each mode and sample. Throws std::invalid_argument for a step or duration that is not
  // positive and finite, a step above the duration, or an acceleration that is not finite.
  DuhamelModes(std::vector<SurgeMode> modes, const AnySurge& motion);

  double duration() const { return times_.back(); }
  // X''(t) [m/s2] as interpolated, 0 <= t <= duration.
  double acceleration(double t) const;
  // The n-th of the modes given, n from 0, at 0 <= t <= duration.
  ModeState state(std::size_t n, double t) const;

 private:
  struct Node {
    double elevation, rate;
  };

  std::size_t interval(double t) const;
  double slope(std::size_t i) const;

  std::vector<SurgeMode> modes_;
  double step_;
  std::vector<double> times_, acceleration_;
  std::vector<Node> nodes_;  // sample by sample, each with all modes
};

}  // namespace slosh::reference
