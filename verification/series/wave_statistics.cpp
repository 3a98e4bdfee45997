#include "verification/series/wave_statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "verification/series/sample_moments.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

constexpr std::size_t fewest_samples = 16;  // twelve differences: the least for a usable median
constexpr double normal_median = 0.6744897501960817;  // median of |x|, x standard normal
constexpr double squared_weights = 70;                // 1 + 16 + 36 + 16 + 1

std::vector<double> fourth_differences(const std::vector<double>& y) {
  std::vector<double> differences;
  for (std::size_t i = 2; i + 2 < y.size(); ++i)
    differences.push_back(y[i - 2] - 4 * y[i - 1] + 6 * y[i] - 4 * y[i + 1] + y[i + 2]);
  return differences;
}

double median_magnitude(std::vector<double> values) {
  for (double& value : values) value = std::abs(value);
  return median(std::move(values));
}

// Returns the share of the time that each sample stands for. All are equal where the samples are
// equally spaced.
std::vector<double> shares_of_time(const std::vector<double>& times) {
  const std::size_t count = times.size();
  if (count == 1) return {1};
  const auto before = [&](std::size_t i) { return i > 0 ? times[i] - times[i - 1] : 0; };
  const auto after = [&](std::size_t i) { return i + 1 < count ? times[i + 1] - times[i] : 0; };
  std::vector<double> shares;
  double whole = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_end = i == 0 || i + 1 == count;
    shares.push_back((before(i) + after(i)) / (is_end ? 1 : 2));
    whole += shares.back();
  }
  for (double& share : shares) share /= whole;
  return shares;
}

}  // namespace

WaveStatistics wave_statistics(const std::vector<double>& times,
                               const std::vector<double>& values) {
  const std::vector<double> share = shares_of_time(times);
  double mean = 0, squares = 0;
  for (std::size_t i = 0; i < values.size(); ++i) mean += share[i] * values[i];
  for (std::size_t i = 0; i < values.size(); ++i)
    squares += share[i] * (values[i] - mean) * (values[i] - mean);
  return {.mean = mean, .deviation = std::sqrt(squares)};
}

double noise_share(const TimeSeries& series) {
  const std::size_t count = series.value.size();
  if (count < fewest_samples)
    throw ComparisonError(fmt::format("{}: only {} samples; expected at least {} to tell noise",
                                      series.name, count, fewest_samples));
  require_variation(series);
  const std::vector<double> samples =
      interpolate(series, uniform_times(series.time.front(), series.time.back(), count));
  const double noise =
      median_magnitude(fourth_differences(samples)) / (normal_median * std::sqrt(squared_weights));
  return noise / rms(without_mean(samples));
}

}  // namespace slosh
