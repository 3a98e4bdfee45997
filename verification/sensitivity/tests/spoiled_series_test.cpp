// Spoiled series against the signal that each must be.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "verification/sensitivity/gate_sensitivity.hpp"
#include "verification/tests/synthetic_series.hpp"

namespace slosh::spoiled_series_test {
namespace {

constexpr double period = 2;    // [s]
constexpr double depth = 0.35;  // [m]
const SpoilingFrame frame{{4, 16}, period, depth};

double wave(double t) { return 0.02 * std::sin(two_pi / period * t + 0.3); }
const TimeSeries series = sampled(wave, 0, 20);

// The largest difference from a signal within the window.
double departure(Spoiling spoiling, const std::function<double(double)>& signal) {
  const TimeSeries wrong = spoiled(series, spoiling, frame);
  EXPECT_EQ(wrong.time, series.time);
  double largest = 0;
  for (std::size_t i = 0; i < wrong.time.size(); ++i)
    if (wrong.time[i] >= frame.window.begin && wrong.time[i] <= frame.window.end)
      largest = std::max(largest, std::abs(wrong.value[i] - signal(wrong.time[i])));
  return largest;
}

TEST(SpoiledSeries, AreTheSignalTooHighLateAndOffItsDatum) {
  constexpr double interpolated = 0.02 * 2e-4;  // at 200 samples a period
  EXPECT_LT(departure(Spoiling::amplitude, [](double t) { return 1.1 * wave(t); }), 1e-15);
  EXPECT_LT(departure(Spoiling::lag, [](double t) { return wave(t - period / 36); }), interpolated);
  EXPECT_LT(departure(Spoiling::datum, [](double t) { return wave(t) + 0.007; }), 1e-15);
}

TEST(SpoiledSeries, HaveATenthOfTheDeviationAsNoiseTheSameAtEveryCall) {
  const TimeSeries noisy = spoiled(series, Spoiling::noise, frame);
  double square = 0;
  for (std::size_t i = 0; i < noisy.value.size(); ++i)
    square += std::pow(noisy.value[i] - series.value[i], 2);
  const double deviation = std::sqrt(square / static_cast<double>(noisy.value.size()));
  EXPECT_NEAR(deviation, 0.1 * 0.02 / std::sqrt(2), 0.05 * 0.1 * 0.02);
  EXPECT_EQ(spoiled(series, Spoiling::noise, frame).value, noisy.value);
}

TEST(SpoiledSeries, EndAFifthOfTheWindowEarlyOrHoldOneNaN) {
  const TimeSeries ends = spoiled(series, Spoiling::truncation, frame);
  EXPECT_NEAR(ends.time.back(), 13.6, 0.0051);
  EXPECT_EQ(ends.value.size(), ends.time.size());
  const TimeSeries poisoned = spoiled(series, Spoiling::not_a_number, frame);
  int poison = 0;
  for (std::size_t i = 0; i < poisoned.value.size(); ++i)
    if (std::isnan(poisoned.value[i])) {
      ++poison;
      EXPECT_NEAR(poisoned.time[i], 10, 0.0051);
    }
  EXPECT_EQ(poison, 1);
}

TEST(SpoiledSeries, AreNotMadeOfASeriesThatMissesTheWindow) {
  EXPECT_THROW(spoiled(sampled(wave, 0, 8), Spoiling::amplitude, frame), ComparisonError);
}

}  // namespace
}  // namespace slosh::spoiled_series_test
