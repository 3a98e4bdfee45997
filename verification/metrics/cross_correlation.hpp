// Lag by normalised cross-correlation, a second opinion on the harmonic fit's phase lag:
//   R(l) = sum_t c(t + l) r(t) / sqrt(sum_t c(t + l)^2 sum_t r(t)^2),
// sums over the overlap at each lag l, both series freed of their least-squares lines; its maximum
// for |l| < period / 2, sub-sample by the parabola through the three highest points. One lag for
// the whole signal: valid where one tone dominates.
#pragma once

#include "verification/series/time_series.hpp"

namespace slosh {

// Lag of the candidate [s], positive when it is late. `period` [s] is the dominant tone's. A
// maximum at the end of the range, as of series in antiphase, comes back without the sub-sample
// part. Throws ComparisonError as cut_to_window() does, and when the window is shorter than one
// period or one of the series does not vary.
double cross_correlation_lag(const TimeSeries& candidate, const TimeSeries& reference,
                             TimeWindow window, double period);

}  // namespace slosh
