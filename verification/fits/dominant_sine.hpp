// The one sine that a motion is nearly made of, of unknown frequency. The highest peak of the power
// spectrum is where the search for the frequency starts; a harmonic fit refines it. A motion passes
// as a sine where the rest of it is small by the rule for machines that vibrate a specimen by a
// sine (IEC 60068-2-6:2007, signal tolerance): the rms value of the signal exceeds that of its sine
// by at most 5 %, so that the rest is at most sqrt(1.05^2 - 1) = 0.32 of the sine in rms.
#pragma once

#include "verification/series/time_series.hpp"

namespace slosh {

struct DominantSine {
  Estimate angular_frequency;  // [rad/s]
  double rest;                 // rms of the series less its mean, trend and sine, over the sine's
};

inline constexpr double largest_rest = 0.3202;

// Throws ComparisonError where there is no such sine: the spectrum has no peak, or its highest one
// has fewer than three periods in the window; the rest is too large; or the window cannot tell the
// sine from another tone, so that its frequency is not determined. Throws also as cut_to_window()
// and require_sampled() do.
DominantSine dominant_sine(const TimeSeries& series, TimeWindow window);

}  // namespace slosh
