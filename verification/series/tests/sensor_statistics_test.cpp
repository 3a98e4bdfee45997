// How often clean signals are taken for those of a sensor's limits, and cut ones are not: thousands
// of signals, which take a minute under the sanitizers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "verification/series/tests/sensor_signals.hpp"

namespace slosh::sensor_statistics_test {
namespace {

using namespace sensor_readings;
using std::numbers::pi;

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

// Waves that stay as they are, of any shape.
struct Shape {
  const char* name;
  std::function<double(double)> of;
};

std::vector<Shape> shapes() {
  const auto two_tones = [](double phase) {
    return [phase](double t) {
      const double angle = two_pi / period * t;
      return std::cos(angle) + 0.3 * std::cos(2 * angle + phase);
    };
  };
  const auto solitary = [](double time, double length) {
    return
        [=](double t) { return std::pow(std::cosh((std::fmod(t, time) - time / 2) / length), -2); };
  };
  const auto ramp = [](double t) { return 0.5 - 0.5 * std::cos(std::clamp(t, 0.0, 1.0) * pi); };
  const auto swing = [](double t) { return t > 0 ? 1 - std::exp(-1.5 * t) * std::cos(4 * t) : 0; };
  return {
      {"sine", wave},
      {"beats", beating},
      {"steep", steep},
      {"two tones in phase", two_tones(0)},
      {"two tones, 60 degrees", two_tones(pi / 3)},
      {"two tones, 90 degrees", two_tones(pi / 2)},
      {"two tones, 120 degrees", two_tones(2 * pi / 3)},
      {"two tones in antiphase", two_tones(pi)},
      {"solitary waves", solitary(4, 0.25)},
      {"solitary waves near to one another", solitary(2, 0.3)},
      {"a steep bore and its fall",
       [](double t) {
         const double since = std::fmod(t, 3.0);
         return 0.5 * (std::tanh((since - 0.5) / 0.05) - std::tanh((since - 2) / 0.3));
       }},
      {"a gentle bore and its fall",
       [](double t) {
         const double since = std::fmod(t, 3.0);
         return 0.5 * (std::tanh((since - 0.5) / 0.15) - std::tanh((since - 2) / 0.3));
       }},
      {"saw teeth", [](double t) { return 1 - 2 * std::fmod(t, period) / period; }},
      {"pointed crests", [](double t) { return -std::abs(std::sin(t)); }},
      {"a tank that is held", [=](double t) { return ramp(t - 2) - ramp(t - 15); }},
      {"a tank that is held and swings", [=](double t) { return swing(t - 2) - swing(t - 20); }},
      {"still water", [](double) { return 0.0; }}};
}

TimeSeries noisy(const std::function<double(double)>& of, double interval, double noise,
                 unsigned seed) {
  return with_noise(sampled(of, 0, 40, interval), noise, 0, seed);
}

TEST(SensorStatistics, DoNotDoubtAShapeOfAWave) {
  int flat = 0, lost = 0;
  for (const auto& [name, of] : shapes())
    for (const double interval : {0.02, 0.05})
      for (const double noise : {1e-9, 0.001, 0.004, 0.01, 0.02}) {
        SCOPED_TRACE(std::string(name) + " " + std::to_string(interval));
        for (unsigned seed = 1; seed <= 20; ++seed) {
          const SensorLimits found = limits_of_all(noisy(of, interval, noise, seed));
          flat += found.highest || found.lowest;
          lost += found.lost.has_value();
          EXPECT_FALSE(found.growth) << noise;
          EXPECT_FALSE((found.highest || found.lowest || found.lost) && noise < 0.01) << noise;
        }
      }
  EXPECT_LE(flat, 1);  // of 3400
  EXPECT_EQ(lost, 0);
}

// A gauge that holds its last reading for `length` samples of each `every`.
std::function<double(double)> holding(std::function<double(double)> of, double interval, int length,
                                      int every, int from) {
  return [=](double t) {
    const int into = (static_cast<int>(std::lround(t / interval)) + from) % every;
    return of(into < length ? t - (into + 1) * interval : t);
  };
}

TEST(SensorStatistics, FindReadingsThatAreHeldInNoise) {
  struct Row {
    double interval, noise;
    int length, every;
    int least;  // of 20
  };
  for (const auto& [interval, noise, length, every, least] :
       {Row{0.01, 0.004, 5, 15, 20}, Row{0.01, 0.004, 5, 50, 20}, Row{0.01, 0.004, 10, 100, 20},
        Row{0.01, 0.02, 10, 30, 20}, Row{0.05, 0.004, 3, 9, 20}, Row{0.05, 0.02, 3, 30, 20},
        Row{0.05, 0.02, 5, 15, 20}, Row{0.05, 0.02, 5, 50, 20}, Row{0.05, 0.004, 10, 30, 20}})
    for (const auto& of : {wave, beating, steep}) {
      int count = 0;
      for (unsigned seed = 1; seed <= 20; ++seed) {
        const auto held = holding(of, interval, length, every, static_cast<int>(seed));
        const SensorLimits found = limits_of_all(noisy(held, interval, noise, seed));
        count += found.lost || found.sparse || found.isolated;
      }
      EXPECT_GE(count, least) << interval << " " << noise << " " << length << " " << every;
    }
}

// A gap of this length about each crest, or beside it.
TEST(SensorStatistics, FindCrestsThatAreFilledByLines) {
  struct Row {
    double interval, noise, gap;
    int least;  // of 20
  };
  for (const auto& [interval, noise, gap, least] :
       {Row{0.01, 0.004, 0.2, 20}, Row{0.02, 0.004, 0.2, 20}, Row{0.01, 0.004, 0.4, 20},
        Row{0.02, 0.02, 0.3, 20}, Row{0.01, 0.02, 0.4, 20}, Row{0.05, 0.004, 0.3, 20},
        Row{0.05, 0.004, 0.4, 20}}) {
    int count = 0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
      const double beside = gap * (0.03 * seed - 0.3);
      const auto filled = [&](double t) {
        const double crest = (two_pi / 4 - 0.4) * period / two_pi + beside;
        const double into = std::remainder(t - crest, period) + gap / 2;
        if (into < 0 || into > gap) return wave(t);
        return std::lerp(wave(t - into), wave(t - into + gap), into / gap);
      };
      const SensorLimits found = limits_of_all(noisy(filled, interval, noise, seed));
      count += found.lost || found.highest;
    }
    EXPECT_GE(count, least) << interval << " " << noise << " " << gap;
  }
}

// Every n-th sample, or a share of them by chance, is low.
TEST(SensorStatistics, FindManySamplesThatAreLow) {
  struct Row {
    int every;
    double share, factor;
  };
  for (const auto& [every, share, factor] :
       {Row{3, 0, 0.7}, Row{3, 0, 0.8}, Row{4, 0, 0.7}, Row{2, 0, 0.8}, Row{0, 0.3, 0.7},
        Row{0, 0.33, 0.7}, Row{0, 0.5, 0.8}, Row{0, 0.6, 0.85}, Row{0, 0.4, 0.8},
        Row{0, 0.35, 0.75}})
    for (const double interval : {period / 26, 0.02})
      for (const double noise : {1e-9, 0.01}) {
        int count = 0;
        for (unsigned seed = 1; seed <= 20; ++seed) {
          std::mt19937 generator(seed);
          std::bernoulli_distribution by_chance(share);
          int sample = 0;
          const auto low = [&](double t) {
            const bool is_low = every > 0 ? ++sample % every == 0 : by_chance(generator);
            return 1.1 * wave(t) * (is_low ? factor : 1);
          };
          const SensorLimits found = limits_of_all(noisy(low, interval, noise, seed));
          count += found.growth || found.isolated || found.lost || found.highest || found.roughness;
        }
        EXPECT_GE(count, 19) << every << " " << share << " " << factor << " " << interval << " "
                             << noise;
      }
}

}  // namespace
}  // namespace slosh::sensor_statistics_test
