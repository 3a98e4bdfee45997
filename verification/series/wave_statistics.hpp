// Statistics of a wave whose single crests depend on small disturbances, as after breaking: the
// moments of one series over a window, and the white noise in it. With y_i the samples and w_i the
// share of the time that each stands for, to the middle between it and its neighbours and as far
// beyond the ends:
//   mean          m = sum w_i y_i
//   deviation     s = sqrt(sum w_i (y_i - m)^2)
//   noise share   median |D^4 y| / (0.6745 sqrt(70)) / s
// with D^4 y = y_(i-2) - 4 y_(i-1) + 6 y_i - 4 y_(i+1) + y_(i+2) of equally spaced samples. White
// noise of deviation sigma gives D^4 y the variance 70 sigma^2 (the sum of the squared weights;
// difference-based variance estimates: Hall, Kay and Titterington 1990, Biometrika 77:521). The
// median magnitude of a normal variable is 0.6745 deviations (Hampel 1974, JASA 69:383), and a
// median ignores the few samples at which a breaker passes the gauge. A sine of deviation s itself
// gives a share of at most (2 sin(pi / n))^4 / 5.6 at n samples per period: 0.0017 at 20.
#pragma once

#include <vector>

#include "verification/series/time_series.hpp"

namespace slosh {

// In the series' unit, measured from its own zero (for an elevation the still level).
struct WaveStatistics {
  double mean, deviation;
};

// The times rise. Requires a sample.
WaveStatistics wave_statistics(const std::vector<double>& times, const std::vector<double>& values);

// The noise share of a series that cut_to_window() has checked. Unequally spaced samples are first
// interpolated to as many equally spaced ones. Throws ComparisonError for fewer than 16 samples and
// for a constant series.
double noise_share(const TimeSeries& series);

}  // namespace slosh
