// Signals whose every parameter is known, for the tests of the metrics.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <random>

#include "verification/series/time_series.hpp"

namespace slosh {

constexpr double two_pi = 2 * std::numbers::pi;

// Every 0.01 s unless told, as the cases record.
inline TimeSeries sampled(const std::function<double(double)>& signal, double begin, double end,
                          double interval = 0.01) {
  TimeSeries series{.name = "elevation@right", .unit = "m", .time = {}, .value = {}};
  const int last = static_cast<int>(std::lround((end - begin) / interval));
  for (int i = 0; i <= last; ++i) {
    series.time.push_back(begin + i * interval);
    series.value.push_back(signal(series.time.back()));
  }
  return series;
}

// Adds first-order autoregressive noise of this standard deviation; correlation 0 is white.
inline TimeSeries with_noise(TimeSeries series, double deviation, double correlation,
                             std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  double noise = deviation * normal(generator);
  for (double& value : series.value) {
    value += noise;
    noise = correlation * noise +
            deviation * std::sqrt(1 - correlation * correlation) * normal(generator);
  }
  return series;
}

}  // namespace slosh
