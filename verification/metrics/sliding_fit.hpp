// The difference between a candidate's tone and a reference's as time goes on: the comparison of
// modes (comparison.hpp) over sliding windows of one length. Every tone is fitted at the requested
// frequency and undamped. The model is then linear, its amplitude is that of the window's middle to
// first order, and a candidate that oscillates at another frequency shows a drifting lag. Whatever
// a window cannot tell from the tones, such as a beat with a neighbour, counts as part of them.
// Windows overlap: values closer than a window's length are not independent.
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

// The fits of the windows that lie in `window`, the first at its begin. Throws ComparisonError as
// compare() does, and when no window fits in.
std::vector<FittedWindow> sliding_fit(const TimeSeries& candidate, const TimeSeries& reference,
                                      TimeWindow window, SlidingWindows sliding,
                                      std::vector<ToneRequest> tones);

// The tones, in their order, that a window of this length [s] resolves from the ones before them
// and from its mean.
std::vector<ToneRequest> resolved_tones(const std::vector<ToneRequest>& tones, double length);

}  // namespace slosh
