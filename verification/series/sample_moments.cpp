#include "verification/series/sample_moments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>

namespace slosh {

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double rms(const std::vector<double>& values) {
  constexpr double least = 1e-250, most = 1e250;  // beyond them squares are lost
  const auto mean_square = [&](double scale) {
    double squares = 0;
    for (const double value : values) squares += (value / scale) * (value / scale);
    return squares / static_cast<double>(values.size());
  };
  const double whole = mean_square(1);
  if (whole >= least && whole <= most) return std::sqrt(whole);
  double scale = 0;
  for (const double value : values) scale = std::max(scale, std::abs(value));
  return scale > 0 && std::isfinite(scale) ? scale * std::sqrt(mean_square(scale))
                                           : std::sqrt(whole);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<double> without_mean(std::vector<double> values) {
  const double m = mean(values);
  for (double& value : values) value -= m;
  return values;
}

std::vector<double> minus(std::vector<double> values, const std::vector<double>& other) {
  if (values.size() != other.size())
    throw std::invalid_argument(
        fmt::format("{} samples less {}; expected as many of both", values.size(), other.size()));
  for (std::size_t i = 0; i < values.size(); ++i) values[i] -= other[i];
  return values;
}

double t95(double freedom) {
  return boost::math::quantile(boost::math::students_t(freedom), 0.975);
}

double two_sided_p(double t, double freedom) {
  return 2 *
         boost::math::cdf(boost::math::complement(boost::math::students_t(freedom), std::abs(t)));
}

}  // namespace slosh
