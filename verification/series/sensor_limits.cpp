#include "verification/series/sensor_limits.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace slosh {
namespace {

constexpr int most_steps = 100;
constexpr double on_levels = 0.9;       // of the samples
constexpr double off_level = 0.01;      // [steps] by rounding
constexpr double least_hidden = 0.015;  // of the range
constexpr double jitter = 1e-3;         // of the range
constexpr std::size_t most_sampled = 20000, fewest_in_flat = 3;

// The values that are read more than once, in order; empty where too few samples have them.
std::vector<double> repeated_values(const std::vector<double>& values) {
  const std::size_t stride = values.size() / most_sampled + 1;
  std::vector<double> sorted;
  for (std::size_t i = 0; i < values.size(); i += stride) sorted.push_back(values[i]);
  std::sort(sorted.begin(), sorted.end());
  std::vector<double> repeated;
  std::size_t samples = 0;
  for (auto at = sorted.begin(); at != sorted.end();) {
    const auto next = std::upper_bound(at, sorted.end(), *at);
    if (next - at > 1) {
      repeated.push_back(*at);
      samples += static_cast<std::size_t>(next - at);
    }
    at = next;
  }
  const bool most = static_cast<double>(samples) >= on_levels * static_cast<double>(sorted.size());
  return most ? repeated : std::vector<double>{};
}

std::optional<double> step_of(const std::vector<double>& values) {
  const std::vector<double> levels = repeated_values(values);
  if (levels.size() < 2 || levels.size() > most_steps) return std::nullopt;
  for (int steps = 1; steps < most_steps; ++steps) {
    const double step = (levels.back() - levels.front()) / steps;
    const auto is_level = [&](double value) {
      const double place = (value - levels.front()) / step;
      return std::abs(place - std::round(place)) <= off_level;
    };
    if (std::all_of(levels.begin(), levels.end(), is_level)) return step;
  }
  return std::nullopt;
}

// By the straight line between the samples.
double value_at(const TimeSeries& series, double time) {
  const auto after = std::lower_bound(series.time.begin(), series.time.end(), time);
  const auto i = static_cast<std::size_t>(after - series.time.begin());
  const double share = (time - series.time[i - 1]) / (series.time[i] - series.time[i - 1]);
  return std::lerp(series.value[i - 1], series.value[i], share);
}

// The flat of the samples from first to last, whose edges lie between these and their neighbours;
// nullopt where it reaches an end of the series.
std::optional<FlatExtreme> flat_of(const TimeSeries& series, double extreme, std::size_t first,
                                   std::size_t last) {
  const std::vector<double>& time = series.time;
  if (first == 0 || last + 1 == time.size()) return std::nullopt;
  const double begin = (time[first - 1] + time[first]) / 2, end = (time[last] + time[last + 1]) / 2,
               half = (end - begin) / 2;
  if (begin - half <= series.time.front() || end + half >= series.time.back()) return std::nullopt;
  const double drop = std::min(std::abs(value_at(series, begin - half) - extreme),
                               std::abs(value_at(series, end + half) - extreme));
  return FlatExtreme{extreme, begin, end, drop / 3};
}

// Of all flats at the extreme the one that hides most.
std::optional<FlatExtreme> flat_extreme(const TimeSeries& series, double extreme, double range) {
  std::optional<FlatExtreme> worst;
  for (std::size_t i = 0; i < series.value.size(); ++i) {
    const std::size_t first = i;
    while (i < series.value.size() && std::abs(series.value[i] - extreme) <= jitter * range) ++i;
    if (i - first < fewest_in_flat) continue;
    const std::optional<FlatExtreme> flat = flat_of(series, extreme, first, i - 1);
    if (flat && flat->hidden >= least_hidden * range && !(worst && worst->hidden >= flat->hidden))
      worst = flat;
  }
  return worst;
}

}  // namespace

SensorLimits sensor_limits(const TimeSeries& cut) {
  if (cut.value.empty()) return {};
  const auto [low, high] = std::minmax_element(cut.value.begin(), cut.value.end());
  const double range = *high - *low;
  if (!(range > 0)) return {};
  return {range, step_of(cut.value), flat_extreme(cut, *high, range),
          flat_extreme(cut, *low, range)};
}

}  // namespace slosh
