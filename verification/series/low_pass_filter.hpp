// A low-pass filter for time series with real spikes, such as an impact's pressure: the mean of the
// samples x_j, weighted by a Gaussian about each sample's time,
//   y_i = sum_j K(t_i - t_j) w_j x_j / sum_j K(t_i - t_j) w_j,   K(t) = exp(-t^2 / (2 sigma^2)),
//   sigma = sqrt(ln 2) / (2 pi f_c)
// with w_j half the time between the neighbours of sample j (the trapezoidal rule), so that the
// sampling may be uneven. K's transform is exp(-(ln 2 / 2) (f / f_c)^2): half the power (-3 dB) at
// the cutoff f_c and no change of phase. No weight is negative, so that a spike does not ring or
// overshoot as it does behind a Butterworth filter. The kernel is cut off at 5 sigma, which leaves
// out 6e-7 of K.
//
// With equal intervals a straight line passes unchanged except in the last 5 sigma at either end,
// where the mean is one-sided. With unequal intervals it is bent slightly where the intervals
// change (at random intervals of 2.5 to 7.5 ms and a cutoff of 5 Hz: by 1 % of the line's change
// over an interval).
#pragma once

#include <string>

#include "verification/series/time_series.hpp"

namespace slosh {

// The filtered series has the same times and the same name; cutoff [Hz]. Throws ComparisonError as
// cut_to_window() does, when the cutoff is not a positive number, when it lies above a third of the
// Nyquist frequency of the widest interval between samples (above it the sampled Gaussian misses
// its gain at the cutoff; at a third the gain is right to 2e-4), and when the series is shorter
// than the filter's 10 sigma, 1.33 / cutoff.
TimeSeries low_pass(const TimeSeries& series, double cutoff);

// The filter's name in reports: "Gaussian, zero phase, -3 dB at 50 Hz".
std::string low_pass_name(double cutoff);

}  // namespace slosh
