#include "verification/sensitivity/spoiled_series.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <stdexcept>

#include "verification/series/sample_moments.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

constexpr double scale = 1.1;
constexpr double lag_in_periods = 10.0 / 360;
constexpr double part_of_datum = 0.02;
constexpr double part_of_deviation = 0.1;
constexpr double part_of_window = 0.2;
constexpr std::uint64_t noise_seed = 20090401;  // arbitrary; fixed, so that reports repeat

void delay(TimeSeries& series, double lag) {
  std::vector<double> times(series.time.size());
  std::transform(series.time.begin(), series.time.end(), times.begin(),
                 [&](double t) { return std::max(t - lag, series.time.front()); });
  series.value = interpolate(series, times);
}

void add_white_noise(TimeSeries& series, double deviation) {
  std::mt19937_64 generator(noise_seed);
  std::normal_distribution<double> normal;
  for (double& value : series.value) value += deviation * normal(generator);
}

void end_at(TimeSeries& series, double last_time) {
  const auto kept = static_cast<std::size_t>(
      std::upper_bound(series.time.begin(), series.time.end(), last_time) - series.time.begin());
  series.time.resize(kept);
  series.value.resize(kept);
}

void poison_at(TimeSeries& series, double time) {
  const auto nearest = std::min_element(
      series.time.begin(), series.time.end(),
      [time](double a, double b) { return std::abs(a - time) < std::abs(b - time); });
  series.value[static_cast<std::size_t>(nearest - series.time.begin())] = not_a_number;
}

}  // namespace

std::string spoiling_name(Spoiling spoiling) {
  switch (spoiling) {
    case Spoiling::amplitude:
      return "amplitude";
    case Spoiling::lag:
      return "lag";
    case Spoiling::datum:
      return "datum";
    case Spoiling::noise:
      return "noise";
    case Spoiling::truncation:
      return "truncation";
    case Spoiling::not_a_number:
      return "NaN";
  }
  throw std::logic_error("a spoiling without a name");
}

TimeSeries spoiled(TimeSeries series, Spoiling spoiling, const SpoilingFrame& frame) {
  const auto [begin, end] = frame.window;
  const TimeSeries judged = cut_to_window(series, frame.window);
  switch (spoiling) {
    case Spoiling::amplitude:
      for (double& value : series.value) value *= scale;
      break;
    case Spoiling::lag:
      delay(series, lag_in_periods * frame.period);
      break;
    case Spoiling::datum:
      for (double& value : series.value) value += part_of_datum * frame.datum;
      break;
    case Spoiling::noise:
      add_white_noise(series, part_of_deviation * rms(without_mean(judged.value)));
      break;
    case Spoiling::truncation:
      end_at(series, end - part_of_window * (end - begin));
      break;
    case Spoiling::not_a_number:
      poison_at(series, std::midpoint(begin, end));
      break;
  }
  return series;
}

}  // namespace slosh
