// The one lag that brings a candidate nearest to a reference, and what is left of the error then:
//   rms_t(c(t + l) - r(t)) / rms_t(r - mean r) -> least over |l| <= a quarter of the reference's
// span, over those of the reference's times t at which the candidate has a value at t + l. For a
// motion that runs away and whose origin of time is known badly (a dam's gate takes time to open):
// then the lag tells of the origin, the rest of speed and shape. Of a swinging quantity take the
// lags of its modes.
#pragma once

#include "verification/series/time_series.hpp"

namespace slosh {

struct TimeAlignment {
  double lag;             // [s], positive when the candidate is late
  double normalised_rms;  // what is left
};

// Of checked series; both numbers NaN where the least lies at an end of the range.
TimeAlignment align_in_time(const TimeSeries& candidate, const TimeSeries& reference);

}  // namespace slosh
