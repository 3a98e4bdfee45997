// One lag for a whole signal, by two methods.
//
// Normalised cross-correlation, a second opinion on the harmonic fit's phase lag:
//   R(l) = sum_t c(t + l) r(t) / sqrt(sum_t c(t + l)^2 sum_t r(t)^2),
// with sums over the overlap at each lag l and both series detrended. The lag is the place of the
// maximum for |l| < period / 2, with sub-sample resolution by the parabola through the three
// highest points; equal series have no lag. Valid where one tone dominates.
//
// Alignment in time, for an advancing front whose time origin is uncertain (a dam's gate takes time
// to open): the lag that minimises the normalised error,
//   rms_t(c(t + l) - r(t)) / rms_t(r - mean r) -> min,
// for |l| up to a quarter of the reference's span and over the reference's times t at which the
// candidate has a value at t + l. The lag then measures the origin, and the remaining error
// measures speed and shape. Minima whose halved squares exceed the least by at most 0.001, or by a
// tenth of it, count as equal, as those of a periodic signal are: the lag nearest to zero is taken.
// An error above 2 is mostly that of another datum or scale, which no lag explains.
// An oscillating quantity has one lag per mode instead.
//
// Both need n log n operations for n samples: the sums of products at all lags are one Fourier
// transform (Wiener-Khinchin), the sums of squares are differences of running sums.
#pragma once

#include "verification/series/time_series.hpp"

namespace slosh {

// Lag of the candidate by cross-correlation [s], positive when it is late. `period` [s] is that of
// the dominant tone. A maximum at the end of the range, as for series in antiphase, is returned
// without the sub-sample part. Throws ComparisonError as cut_to_window() does, and when the overlap
// is shorter than one period or one of the series is constant.
double cross_correlation_lag(const TimeSeries& candidate, const TimeSeries& reference,
                             TimeWindow window, double period);

struct TimeAlignment {
  double lag;             // [s], positive when the candidate is late
  double normalised_rms;  // the remaining error
};

// Aligns two checked series. Both numbers are NaN where the minimum lies at an end of the range, or
// leaves more than 2. Of more than 200000 samples of the reference, every k-th serves to find the
// lag.
TimeAlignment align_in_time(const TimeSeries& candidate, const TimeSeries& reference);

}  // namespace slosh
