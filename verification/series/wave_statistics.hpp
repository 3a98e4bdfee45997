// What describes a wave whose single crests small disturbances decide, as after breaking: moments
// and extremes of one series over a window, and the white noise in it. With y_i the samples, m
// their mean and T the wave's period:
//   deviation     s = sqrt(sum (y_i - m)^2 / n)
//   crest         mean over the whole periods of max y in the period
//   trough        mean over the whole periods of min y in the period
//   noise share   median |D^4 y| / (0.6745 sqrt(70)) / s
// with D^4 y = y_(i-2) - 4 y_(i-1) + 6 y_i - 4 y_(i+1) + y_(i+2) of equally spaced samples. White
// noise of deviation sigma gives D^4 y the variance 70 sigma^2 (the sum of the squared weights;
// difference-based variance estimates: Hall, Kay and Titterington 1990, Biometrika 77:521), the
// median of a normal variable's magnitude is 0.6745 deviations (Hampel 1974, JASA 69:383), and a
// median does not see the few samples at which a breaker passes the gauge. A sine of deviation s
// itself leaves a share of at most (2 sin(pi / n))^4 / 5.6 at n samples a period: 0.0017 at 20.
#pragma once

#include "verification/series/time_series.hpp"

namespace slosh {

// In the series' unit and from its own zero, of an elevation the still level: after breaking the
// crests scatter from run to run, the troughs hardly, so that these see a datum that is off.
struct WaveStatistics {
  double mean, deviation;
  double crest, trough;  // NaN of less than one whole period
};

// Of a series that cut_to_window() has checked; the periods [s] begin at its first sample.
WaveStatistics wave_statistics(const TimeSeries& series, double period);

// Of such a series that varies; unequally spaced samples are first interpolated to as many equally
// spaced ones. Throws ComparisonError of fewer than 16 samples and of a series that does not vary.
double noise_share(const TimeSeries& series);

}  // namespace slosh
