#include "verification/metrics/sliding_fit.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace slosh {

std::vector<FittedWindow> sliding_fit(const TimeSeries& candidate, const TimeSeries& reference,
                                      TimeWindow window, SlidingWindows sliding,
                                      std::vector<ToneRequest> tones) {
  for (ToneRequest& tone : tones) tone.refine = false;
  // The summand allows for round-off where the last window just fits.
  const double places = (window.end - window.begin - sliding.length) / sliding.step + 1e-9;
  if (!(places >= 0))
    throw ComparisonError(fmt::format("windows of {:.4g} s do not fit in {:.4g} s", sliding.length,
                                      window.end - window.begin));
  std::vector<FittedWindow> fits;
  for (int i = 0; i <= static_cast<int>(places); ++i) {
    const double begin = window.begin + i * sliding.step;
    const TimeWindow part{begin, std::min(begin + sliding.length, window.end)};
    fits.push_back({(part.begin + part.end) / 2, compare_modes(candidate, reference, part, tones)});
  }
  return fits;
}

std::vector<ToneRequest> resolved_tones(const std::vector<ToneRequest>& tones, double length) {
  std::vector<ToneRequest> resolved;
  for (const ToneRequest& tone : tones) {
    resolved.push_back(tone);
    try {
      require_resolved({0, length}, resolved);
    } catch (const ComparisonError&) {
      resolved.pop_back();
    }
  }
  return resolved;
}

}  // namespace slosh
