#include "verification/series/wave_statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "verification/series/sample_moments.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

constexpr std::size_t fewest_samples = 16;  // twelve differences: the least for a usable median
constexpr double normal_median = 0.6744897501960817;  // median of |x|, x standard normal
constexpr double squared_weights = 70;                // 1 + 16 + 36 + 16 + 1

struct Extremes {
  double high = -std::numeric_limits<double>::infinity();
  double low = std::numeric_limits<double>::infinity();
};

// The extremes of each whole period that has a sample; a period cut short by the window is left
// out.
std::vector<Extremes> extremes_by_period(const TimeSeries& series, double period) {
  const double begin = series.time.front();
  // The factor only allows for the rounding of sample times.
  const double whole = std::floor((series.time.back() - begin) / period * (1 + 1e-9));
  std::vector<Extremes> found(static_cast<std::size_t>(std::max(0.0, whole)));
  for (std::size_t i = 0; i < series.time.size(); ++i) {
    const auto k = static_cast<std::size_t>((series.time[i] - begin) / period);
    if (k >= found.size()) continue;
    found[k].high = std::max(found[k].high, series.value[i]);
    found[k].low = std::min(found[k].low, series.value[i]);
  }
  std::erase_if(found, [](const Extremes& one) { return !(one.high >= one.low); });
  return found;
}

std::vector<double> fourth_differences(const std::vector<double>& y) {
  std::vector<double> differences;
  for (std::size_t i = 2; i + 2 < y.size(); ++i)
    differences.push_back(y[i - 2] - 4 * y[i - 1] + 6 * y[i] - 4 * y[i + 1] + y[i + 2]);
  return differences;
}

double median_magnitude(std::vector<double> values) {
  for (double& value : values) value = std::abs(value);
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

WaveStatistics wave_statistics(const TimeSeries& series, double period) {
  std::vector<double> highs, lows;
  for (const Extremes& one : extremes_by_period(series, period)) {
    highs.push_back(one.high);
    lows.push_back(one.low);
  }
  return {.mean = mean(series.value),
          .deviation = rms(without_mean(series.value)),
          .crest = mean(highs),
          .trough = mean(lows)};
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
