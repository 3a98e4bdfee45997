// Harmonic least squares: y = c0 + c1 t + sum_k exp(-g_k t) (a_k cos w_k t + b_k sin w_k t) over a window.
// The primary metric of the harness: fit the forcing and the natural modes together, because one tone
// fitted to a beating signal mis-states both amplitude and lag.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "verification/metrics/time_series.hpp"

namespace slosh {

// Nothing can be compared: no overlap, a truncated or non-finite series, a window too short for the modes.
struct ComparisonError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A value and half the width of its 95 % confidence interval, in the same unit.
struct Estimate {
  double value;
  double half_width;
};

// A mode to be fitted. The forced mode's frequency is known and it does not decay; a natural mode's
// frequency and decay rate are refined from the data by nonlinear least squares.
struct ToneRequest {
  std::string name;
  double angular_frequency;  // [rad/s]
  bool refine;
};

struct Tone {
  std::string name;
  Estimate angular_frequency;  // [rad/s]
  Estimate decay_rate;         // [1/s], amplitude ~ exp(-decay_rate t)
  Estimate amplitude;          // at t = window.begin, in the series' unit
  Estimate phase;              // [rad], y ~ amplitude cos(w t + phase), phase = atan2(-b, a), t as in the series
};

struct HarmonicFit {
  double mean;   // c0 at the window's middle
  double trend;  // c1 [unit/s]
  std::vector<Tone> tones;  // in the order of the requests
  double residual_rms;
};

HarmonicFit fit_harmonics(const TimeSeries& series, TimeWindow window,
                          const std::vector<ToneRequest>& requests);

}  // namespace slosh
