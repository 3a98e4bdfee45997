// Moments of samples x_1 .. x_n with equal weights, whatever their times:
//   mean m = sum x_i / n,   rms = sqrt(sum x_i^2 / n)
// Both are NaN for no samples. The median is the upper one of two. Student's t distribution gives
// the interval of the mean of few samples. Boost's headers for it are large, so sample_moments.cpp
// is the one file that reads them.
#pragma once

#include <vector>

namespace slosh {

double mean(const std::vector<double>& values);
double rms(const std::vector<double>& values);

// Requires a value.
double median(std::vector<double> values);

// The values less their mean; their rms is the standard deviation (with n, not n - 1).
std::vector<double> without_mean(std::vector<double> values);

// The difference sample by sample. Throws std::invalid_argument unless both have the same length.
std::vector<double> minus(std::vector<double> values, const std::vector<double>& other);

// The half width of the two-sided 95 % interval of a mean, in its standard errors. `freedom` > 0.
double t95(double freedom);

// The probability that |t| is exceeded. `freedom` > 0.
double two_sided_p(double t, double freedom);

}  // namespace slosh
