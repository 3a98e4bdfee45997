// How a candidate's tone stands to a reference's as time goes on: the pair of comparison.hpp over
// windows of one length that slide along. Every tone is fitted at the frequency that it is asked
// for and undamped: the model is linear, its amplitude that of the window's middle to the first
// order, and a candidate that swings at another frequency shows as a lag that drifts. What a window
// cannot tell from the tones, a beat with a neighbour, counts to them. Windows overlap: values
// nearer than a length are not independent.
#pragma once

#include <vector>

#include "verification/metrics/comparison.hpp"

namespace slosh {

struct SlidingWindows {
  double length, step;  // [s], above zero
};

struct FittedWindow {
  double middle;                      // [s]
  std::vector<ModeComparison> modes;  // in the order of the tones
};

// Those that lie in `window`, the first at its begin. Throws ComparisonError as compare() does, and
// where not one fits in.
std::vector<FittedWindow> sliding_fit(const TimeSeries& candidate, const TimeSeries& reference,
                                      TimeWindow window, SlidingWindows sliding,
                                      std::vector<ToneRequest> tones);

// Of the tones, in their order, those that a window of this length [s] tells from the ones before
// them and from its mean.
std::vector<ToneRequest> resolved_tones(const std::vector<ToneRequest>& tones, double length);

}  // namespace slosh
