// A low-pass filter for histories whose spikes are real, such as an impact's pressure: the mean of
// the samples x_j under a Gaussian about each sample's time,
//   y_i = sum_j K(t_i - t_j) w_j x_j / sum_j K(t_i - t_j) w_j,   K(t) = exp(-t^2 / (2 sigma^2)),
//   sigma = sqrt(ln 2) / (2 pi f_c)
// with w_j half the time between the neighbours of sample j (the trapezoidal rule), so that any
// sampling will do. K's transform is exp(-(ln 2 / 2) (f / f_c)^2): half the power (-3 dB) at the
// cutoff f_c, no change of phase, and no negative weight, so that a spike does not ring or
// overshoot, as it does behind a Butterworth filter. Cut off at 5 sigma, beyond which lie 6e-7
// of K.
//
// With equal intervals a straight line passes unchanged but for the last 5 sigma at either end,
// where the mean is one-sided; with unequal ones it is bent a little where the intervals change
// (2.5 to 7.5 ms at random, cutoff 5 Hz: by 1 % of what the line changes by in an interval).
#pragma once

#include <string>

#include "verification/series/time_series.hpp"

namespace slosh {

// The filtered series at the same times, its name with "/filtered" appended; cutoff [Hz]. Throws
// ComparisonError as cut_to_window() does, when the cutoff is not a positive number, when it lies
// above a third of the Nyquist frequency of the widest interval between samples (from there on the
// sampled Gaussian misses its gain at the cutoff; at a third it is right to 2e-4), and when the
// series is shorter than the filter's 10 sigma, 1.33 / cutoff.
TimeSeries low_pass(const TimeSeries& series, double cutoff);

// For reports: "Gaussian, zero phase, -3 dB at 50 Hz".
std::string low_pass_name(double cutoff);

}  // namespace slosh
