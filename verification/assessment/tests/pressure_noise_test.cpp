// The noise of a pressure: that of known tones, and none where the sampling cannot show it.
#include "verification/assessment/pressure_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "verification/tests/impact_results.hpp"
#include "verification/tests/sample_case.hpp"

namespace slosh::pressure_noise_test {
namespace {

constexpr TimeWindow window{1, 9};

template <class Function>
TimeSeries series_of(const Function& f) {
  TimeSeries series{"wall_pressure@B", "Pa", {}, {}};
  for (int i = 0; i <= 2000; ++i) {
    series.time.push_back(0.005 * i);
    series.value.push_back(f(0.005 * i));
  }
  return series;
}

double tone(double frequency, double t) { return std::sin(2 * std::numbers::pi * frequency * t); }

TEST(PressureNoise, IsThePowerOfATonesAboveTheBandOverThatOfAll) {
  const auto pressure = [](double t) { return 3000 + 300 * tone(0.8, t) + 20 * tone(20, t); };
  const double all = 3000.0 * 3000 + 300 * 300 / 2 + 20 * 20 / 2;
  EXPECT_NEAR(pressure_noise(series_of(pressure), window, 5) / (20 * 20 / 2 / all), 1, 0.02);
}

TEST(PressureNoise, OfWhiteNoiseIsItsMeanSquareAboveTheBand) {
  std::mt19937 random(1);
  std::normal_distribution<double> white(0, 50);
  const TimeSeries pressure = series_of([&](double) { return 1000 + white(random); });
  const double share = 95.0 / 100;  // of the frequencies up to 100 Hz above 5 Hz
  EXPECT_NEAR(pressure_noise(pressure, window, 5) / (share * 2500 / (1e6 + 2500)), 1, 0.1);
}

TEST(PressureNoise, OfAWaveAloneIsNearlyNoneAndOfNoPressureThatCannotShowIt) {
  TimeSeries wave = series_of([](double t) { return 3000 + 300 * tone(0.8, t); });
  EXPECT_LT(pressure_noise(wave, window, 5), 1e-8);
  EXPECT_THROW(pressure_noise(wave, window, 50), ComparisonError);
  EXPECT_NO_THROW(pressure_noise(wave, window, 49));
  wave.value[1000] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(pressure_noise(wave, window, 5), ComparisonError);
}

// A plateau that falls by a line, and a tone of 10 Pa upon it; the impacts' peaks do not count.
TEST(PlateauNoise, IsThatOfATonesRmsOverThePlateau) {
  TimeSeries pressure = pressure_of({});
  for (std::size_t i = 0; i < pressure.value.size(); ++i)
    pressure.value[i] += 10 * tone(50, pressure.time[i]) + 100 * pressure.time[i];
  EXPECT_NEAR(plateau_noise(pressure, impact_case()), 10 / std::numbers::sqrt2 / 670, 1e-4);
}

TEST(PlateauNoise, LeavesOutPlateausBeyondTheRun) {
  CaseDefinition definition = impact_case();
  definition.duration = 7.5;
  TimeSeries pressure = pressure_of({.until = 7.5});
  for (std::size_t i = 0; i < pressure.value.size(); ++i)
    pressure.value[i] += 10 * tone(50, pressure.time[i]);
  EXPECT_NEAR(plateau_noise(pressure, definition), 10 / std::numbers::sqrt2 / 670, 1e-4);
  EXPECT_THROW(plateau_noise(pressure, impact_case()), ComparisonError);
  EXPECT_THROW(plateau_noise(pressure_of({}), sample_case()), ComparisonError) << "no impacts";
  pressure.value[2500] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(plateau_noise(pressure, definition), ComparisonError);
}

// The sample's third mode that surge excites: k = 5 pi, omega^2 = g k tanh(k h).
TEST(NoiseBand, IsThreeTimesTheThirdModeOrFiveHertz) {
  const CaseDefinition definition = sample_case();
  const double k = 5 * std::numbers::pi;
  const double mode = std::sqrt(9.81 * k * std::tanh(k * 0.35)) / (2 * std::numbers::pi);
  EXPECT_NEAR(noise_band(definition), 3 * mode, 1e-9);
  CaseDefinition slow = definition;
  slow.tank.length = 5;
  EXPECT_EQ(noise_band(slow), 5);
}

}  // namespace
}  // namespace slosh::pressure_noise_test
