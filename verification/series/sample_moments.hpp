// Moments of samples x_1 .. x_n that all count alike, whatever their times:
//   mean m = sum x_i / n,   rms = sqrt(sum x_i^2 / n)
// NaN of no samples.
#pragma once

#include <vector>

namespace slosh {

double mean(const std::vector<double>& values);
double rms(const std::vector<double>& values);

// Each less the mean of all: their rms is the samples' own standard deviation.
std::vector<double> without_mean(std::vector<double> values);

// Sample by sample. Throws std::invalid_argument unless `other` has as many.
std::vector<double> minus(std::vector<double> values, const std::vector<double>& other);

}  // namespace slosh
