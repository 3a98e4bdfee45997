// How often clean signals are taken for those of a sensor's limits, and cut ones are not: thousands
// of signals, which take a minute under the sanitizers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "verification/series/tests/sensor_signals.hpp"

namespace slosh::sensor_statistics_test {
namespace {

using namespace sensor_readings;

// How many of 20 records of 40 s have a flat crest, and a flat trough: waves of the height 1 to -1
// or so, cut by a share of that, with noise and in steps that are shares of the range.
struct Told {
  int highest = 0, lowest = 0;
};

template <class Wave>
Told told(const Wave& of, double interval, double cut, double noise, double steps) {
  Told found;
  const TimeSeries round = sampled(of, 0, 40, 0.001);
  const auto ends = std::ranges::minmax(round.value);
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 generator(seed);
    std::normal_distribution<double> normal;
    const double range = ends.max - ends.min;
    const SensorLimits limits = limits_of_all(sampled(
        [&](double t) {
          const double value =
              std::min(of(t), ends.max - cut * range / 2) + noise * range * normal(generator);
          return steps > 0 ? in_steps(value, range / steps) : value;
        },
        0, 40, interval));
    found.highest += limits.highest.has_value();
    found.lowest += limits.lowest.has_value();
  }
  return found;
}

double beating(double t) { return wave(t) + 0.2 * std::sin(two_pi / 3.1 * t); }
// Nearly x^4 at its troughs.
double steep(double t) { return wave(t) - 0.2 * std::cos(2 * (two_pi / period * t + 0.4)); }

TEST(SensorStatistics, DoNotTakeARoundCrestForAFlatWhateverItsNoiseAndSteps) {
  Told all;
  for (const auto& of : {wave, beating, steep})
    for (const double interval : {0.02, 0.05, 0.1})
      for (const double noise : {0.0, 0.0005, 0.002, 0.005, 0.01})
        for (const double steps : {0.0, 98.0, 30.0, 10.0}) {
          const Told found = told(of, interval, 0, noise, steps);
          all.highest += found.highest;
          all.lowest += found.lowest;
        }
  EXPECT_EQ(all.highest, 0);
  EXPECT_LE(all.lowest, 5);  // of 3600: nearly x^4, in noise of half a step
}

TEST(SensorStatistics, FindAClippedCrestBelowItsNoise) {
  struct Row {
    double noise, steps, cut;
    int least;  // of 20
  };
  for (const auto& [noise, steps, cut, least] :
       {Row{0.0005, 0, 0.04, 20}, Row{0.002, 0, 0.06, 20}, Row{0.002, 0, 0.1, 20},
        Row{0.005, 0, 0.1, 16}, Row{0.005, 0, 0.2, 20}, Row{0.01, 0, 0.3, 20}, Row{0, 98, 0.1, 20},
        Row{0.002, 98, 0.2, 20}, Row{0.01, 98, 0.3, 20}})
    for (const double interval : {0.005, 0.02}) {
      const Told found = told(wave, interval, cut, noise, steps);
      EXPECT_GE(found.highest, least) << noise << " " << steps << " " << cut << " " << interval;
      EXPECT_EQ(found.lowest, 0) << noise << " " << steps << " " << cut;
    }
}

// Of a wave, a wave between rests, and a wall's pressure that falls dry.
TEST(SensorStatistics, DoNotTakeNoiseOrRestsForSparseReadings) {
  const auto intermittent = [](double t) { return std::pow(std::max(wave(t), 0.0), 4); };
  const auto impacts = [](double t) {
    const double since = std::fmod(t, period);
    return since < 0.7 ? 0 : std::exp(-(since - 0.7) / 0.1);
  };
  for (const auto& of : {std::function<double(double)>(wave), {intermittent}, {impacts}})
    for (const double interval : {0.001, 0.02, 0.1})
      for (const double noise : {0.0, 1e-3, 0.01, 0.1, 1.0})
        for (unsigned seed = 1; seed <= 10; ++seed) {
          std::mt19937 generator(seed);
          std::normal_distribution<double> normal;
          const auto noisy = [&](double t) { return of(t) + noise * normal(generator); };
          const SensorLimits found = limits_of_all(sampled(noisy, 0, 40, interval));
          EXPECT_FALSE(found.sparse) << interval << " " << noise;
          EXPECT_FALSE(found.isolated && !found.isolated->above) << interval << " " << noise;
        }
}

}  // namespace
}  // namespace slosh::sensor_statistics_test
