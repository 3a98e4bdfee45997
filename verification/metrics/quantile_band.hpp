// How a series keeps to a band, such as the quantiles of an experiment's repeats. The margin
//   m = min(c - lower, upper - c)
// of the candidate c is positive inside the band and negative outside, where -m is the distance to
// its nearer edge. Between two samples c, lower and upper are straight lines. The margin then has a
// corner where the nearer edge changes and is linear to either side of it. A front that crosses the
// whole band between two samples is inside for a part of that time, although it is outside at both.
// A candidate need not lie inside the band to the same share as one repeat of the experiment does:
// a band of the quantiles 2.5 and 97.5 % holds a repeat for 95 % of the time on average.
#pragma once

#include <vector>

#include "verification/series/time_series.hpp"

namespace slosh {

// The edges at the times of the series about which the band lies.
struct QuantileBand {
  TimeSeries lower, upper;
};

// The margin of a candidate's values at these times, all of which lie within the band's, in the
// band's unit. The margin also has a sample at each of its corners, so that it is linear between
// any two of its samples.
TimeSeries band_margin(const std::vector<double>& time, const std::vector<double>& candidate,
                       const QuantileBand& band);

// The share of the window's time for which the margin is negative. Throws ComparisonError
// where the window is empty or reaches beyond the margin by more than its longest interval between
// samples, and returns NaN where a value in the window is not finite.
double share_outside(const TimeSeries& margin, TimeWindow window);

}  // namespace slosh
