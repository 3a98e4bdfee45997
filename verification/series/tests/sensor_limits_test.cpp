#include "verification/series/readings/sensor_limits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "verification/series/tests/sensor_signals.hpp"

namespace slosh::sensor_limits_test {
namespace {

using namespace sensor_readings;

TEST(SensorLimits, FindTheStepOfAnySensorOfFewLevels) {
  for (const double step : {1.0, 0.5, 0.13, 0.05, 0.025})
    for (const double interval : {0.001, 0.01, 0.05}) {
      const auto read = [&](double t) { return 0.3 + in_steps(wave(t), step); };
      const SensorLimits found = limits_of_all(sampled(read, 0, 40, interval));
      ASSERT_TRUE(found.step) << step << " " << interval;
      EXPECT_NEAR(*found.step, step, 1e-9);
    }
}

// Written with six digits, the levels are no exact multiples of the step.
TEST(SensorLimits, FindTheStepOfRoundedLevels) {
  const auto read = [](double t) { return in_steps(in_steps(wave(t), 1.0 / 3), 1e-6); };
  EXPECT_NEAR(limits_of_all(sampled(read, 0, 40)).step.value(), 1.0 / 3, 1e-5);
}

TEST(SensorLimits, DoNotDoubtFineStepsOrValuesThatRecurWithThePeriod) {
  for (const double step : {0.0199, 0.01, 1e-4, 1e-9})
    for (const double interval : {0.0005, 0.01, 0.05, period / 20, period / 10, period / 16}) {
      const SensorLimits found = limits_of_all(
          sampled([&](double t) { return in_steps(wave(t), step); }, 0, 40, interval));
      EXPECT_FALSE(found.step) << step << " " << interval;
      EXPECT_FALSE(found.highest) << step << " " << interval;
      EXPECT_FALSE(found.lowest) << step << " " << interval;
    }
}

TEST(SensorLimits, MeasureWhatAClippedCrestHides) {
  for (const double cut : {0.05, 0.12, 0.3})
    for (const double interval : {0.001, 0.01, 0.02}) {
      const auto read = [&](double t) { return std::min(wave(t), 1 - cut); };
      const SensorLimits found = limits_of_all(sampled(read, 0, 40, interval));
      ASSERT_TRUE(found.highest) << cut << " " << interval;
      EXPECT_NEAR(found.highest->hidden, cut, 0.35 * cut + 0.03) << interval;
      EXPECT_EQ(found.highest->value, 1 - cut);
      EXPECT_FALSE(found.lowest);
    }
}

TEST(SensorLimits, FindAClippedTroughAndASingleClippedImpact) {
  EXPECT_TRUE(
      limits_of_all(sampled([](double t) { return std::max(wave(t), -0.9); }, 0, 40)).lowest);
  const auto impact = [](double t) {
    return std::min(3.0, 5 * std::exp(-(t - 7) * (t - 7) / 0.01));
  };
  EXPECT_TRUE(limits_of_all(sampled(impact, 0, 10, 0.005)).highest);
}

TEST(SensorLimits, DoNotTakeARestBeforeOrAfterTheMotionForACrest) {
  const auto front = [](double t) { return std::clamp(t - 2, 0.0, 3.0); };
  const SensorLimits found = limits_of_all(sampled(front, 0, 8));
  EXPECT_FALSE(found.highest);
  EXPECT_FALSE(found.lowest);
  EXPECT_FALSE(limits_of_all(sampled([](double) { return 2.0; }, 0, 8)).step);
}

TEST(SensorLimits, FindAClippedCrestWhoseReadingsJitter) {
  for (const double jitter : {1e-9, 1e-7, 1e-5, 5e-4}) {
    int count = 0;
    const auto read = [&](double t) {
      const double cut = 0.9 - jitter * (count++ % 3);
      return std::min(wave(t), cut);
    };
    EXPECT_TRUE(limits_of_all(sampled(read, 0, 40)).highest) << jitter;
  }
}

TEST(SensorLimits, DoNotTakeARoundOrAPointedCrestForAFlat) {
  for (const double interval : {0.0001, 0.001, 0.01}) {
    const auto pointed = [](double t) { return -std::abs(std::sin(t)); };
    for (const TimeSeries& one :
         {sampled(wave, 0, 12, interval), sampled(pointed, 0, 12, interval)}) {
      EXPECT_FALSE(limits_of_all(one).highest) << interval;
      EXPECT_FALSE(limits_of_all(one).lowest) << interval;
    }
  }
}

// A logger's own interval, and a program's that writes what it interpolates.
TEST(SensorLimits, FindReadingsThatAreHeldOrJoinedByLines) {
  for (const double interval : {0.005, 0.02}) {
    for (const double sparse : {2 * interval, 0.1, 0.3}) {
      const auto reading = [&](double t) { return wave(std::floor(t / sparse + 1e-9) * sparse); };
      const SensorLimits held = limits_of_all(sampled(reading, 0, 20, interval));
      const bool matters = sparse > 0.02;  // a lag of 1.3 degrees
      ASSERT_EQ(held.sparse.has_value(), matters) << sparse << " " << interval;
      if (!matters) continue;
      EXPECT_TRUE(held.sparse->held);
      EXPECT_NEAR(held.sparse->interval, sparse, 1e-9);
    }
    const double sparse = 0.3;
    const auto line = [&](double t) {
      const double begin = std::floor(t / sparse + 1e-9) * sparse;
      return std::lerp(wave(begin), wave(begin + sparse), (t - begin) / sparse);
    };
    const SensorLimits joined = limits_of_all(sampled(line, 0, 20, interval));
    ASSERT_TRUE(joined.sparse) << interval;
    EXPECT_FALSE(joined.sparse->held);
    EXPECT_NEAR(joined.sparse->interval, sparse, 1e-9);
    EXPECT_NEAR(joined.sparse->hidden, 1 - std::cos(two_pi / period * sparse / 2), 0.1);
  }
}

TEST(SensorLimits, DoNotTakeFewOrLostSamplesARestOrASmoothWaveForSparseReadings) {
  std::mt19937 draw(3);
  std::bernoulli_distribution lost(0.4);
  for (const double interval : {0.0001, 0.001, 0.01, 0.1, 0.3}) {
    TimeSeries series =
        sampled([](double t) { return t < 8 ? 0 : wave(t) - wave(8); }, 0, 20, interval);
    EXPECT_FALSE(limits_of_all(series).sparse) << interval;
    TimeSeries part{series.name, series.unit, {}, {}};
    for (std::size_t i = 0; i < series.time.size(); ++i)
      if (!lost(draw)) {
        part.time.push_back(series.time[i]);
        part.value.push_back(series.value[i]);
      }
    EXPECT_FALSE(limits_of_all(part).sparse) << interval;
  }
}

// In noise of a record's digits, and where a part of the window alone is fine.
TEST(SensorLimits, FindHeldAndJoinedReadingsInNoiseAndInAPartOfTheWindow) {
  const double interval = 0.02;
  for (const double noise : {0.0, 2e-4, 4e-3})
    for (const double begin_of_fine : {9.0, 16.0, 20.0}) {
      std::mt19937 generator(5);
      std::normal_distribution<double> normal;
      const auto held = [&](double t) {
        const double at = t < begin_of_fine ? std::floor(t / 0.16 + 1e-9) * 0.16 : t;
        return wave(at) + noise * normal(generator);
      };
      const SensorLimits found = limits_of_all(sampled(held, 0, 20, interval));
      ASSERT_TRUE(found.sparse) << noise << " " << begin_of_fine;
      EXPECT_TRUE(found.sparse->held);
      EXPECT_NEAR(found.sparse->interval, 0.16, 0.02);
    }
  std::mt19937 generator(5);
  std::normal_distribution<double> normal;
  const auto line = [&](double t) {
    const double begin = std::floor(t / 0.4 + 1e-9) * 0.4;
    return std::lerp(wave(begin), wave(begin + 0.4), (t - begin) / 0.4) + 2e-4 * normal(generator);
  };
  EXPECT_TRUE(limits_of_all(sampled(line, 0, 20, interval)).sparse);
}

TEST(SensorLimits, FindIsolatedReadingsAndAClippedCrestBelowASpike) {
  for (const double interval : {0.005, 0.02, 0.05})
    for (const int every : {6, 10, 30})
      for (const double noise : {0.0, 0.01}) {
        std::mt19937 generator(2);
        std::normal_distribution<double> normal;
        int count = 0;
        const auto lost = [&](double t) {
          return ++count % every == 0 ? 0 : wave(t) + noise * normal(generator);
        };
        const SensorLimits found = limits_of_all(sampled(lost, 0, 20, interval));
        ASSERT_TRUE(found.isolated) << interval << " " << every << " " << noise;
        EXPECT_NEAR(found.isolated->hidden, 0.64 / every, 0.2 / every);
      }
  for (const int length : {1, 2}) {
    int count = 0;
    const auto spiked = [&](double t) {
      ++count;
      if (count > 500 && count <= 500 + length) return 1.3;
      if (count > 700 && count <= 700 + length) return -1.3;
      return std::clamp(wave(t), -0.8, 0.8);
    };
    const SensorLimits found = limits_of_all(sampled(spiked, 0, 20, 0.02));
    ASSERT_TRUE(found.highest && found.lowest) << length;
    EXPECT_EQ(found.highest->value, 0.8);
    EXPECT_EQ(found.lowest->value, -0.8);
    EXPECT_FALSE(found.isolated);  // of 1000 readings, too few to matter
  }
}

// A sensor whose range was switched, and one whose filter overshoots at the edges of each flat.
TEST(SensorLimits, FindCrestsThatAreCutOffBelowTheHighestValue) {
  for (const double interval : {0.01, 0.02})
    for (const double cut : {0.1, 0.3})
      for (const double noise : {0.0, 5e-4}) {
        std::mt19937 generator(2);
        std::normal_distribution<double> normal;
        const auto noisy = [&](double value) { return value + noise * normal(generator); };
        const auto switched = [&](double t) {
          return noisy(t < 10 ? std::min(wave(t), 1 - cut) : wave(t));
        };
        const SensorLimits half = limits_of_all(sampled(switched, 0, 20, interval));
        ASSERT_TRUE(half.highest) << interval << " " << cut << " " << noise;
        EXPECT_NEAR(half.highest->value, 1 - cut, 0.01);
        EXPECT_LT(half.highest->end, 10.1);
        EXPECT_FALSE(half.lowest);
        for (const std::size_t samples : {1U, 2U}) {
          std::size_t above = 0, below = 0;
          const auto ringing = [&](double t) {
            above = wave(t) > 1 - cut ? above + 1 : 0;
            below = wave(t) < cut - 1 ? below + 1 : 0;
            const double over = above + below > 0 && above + below <= samples ? 0.06 : 0;
            const double value = std::clamp(wave(t), cut - 1, 1 - cut);
            return noisy(value + (value > 0 ? over : -over));
          };
          const SensorLimits found = limits_of_all(sampled(ringing, 0, 20, interval));
          ASSERT_TRUE(found.highest && found.lowest) << interval << " " << cut << " " << samples;
          EXPECT_NEAR(found.highest->value, 1 - cut, 0.01);
          EXPECT_NEAR(found.lowest->value, cut - 1, 0.01);
        }
      }
}

// An echo that is lost for several samples at a time reads one value.
TEST(SensorLimits, FindSeveralLostSamplesInARow) {
  for (const int length : {2, 3, 4, 8})
    for (const double noise : {0.0, 0.01}) {
      std::mt19937 generator(2);
      std::normal_distribution<double> normal;
      int count = 0;
      const auto lost = [&](double t) {
        return ++count % (10 * length) < length ? 0.1 : wave(t) + noise * normal(generator);
      };
      const SensorLimits found = limits_of_all(sampled(lost, 0, 20, 0.01));
      ASSERT_TRUE(found.isolated) << length << " " << noise;
      EXPECT_DOUBLE_EQ(found.isolated->value.value(), 0.1);
      EXPECT_NEAR(found.isolated->hidden, 0.064, 0.02);
    }
}

// Two channels in one column, the one dry, give a fitted sine the amplitude that it should have.
TEST(SensorLimits, FindSignalsThatAlternate) {
  const std::vector<std::vector<double>> shares{
      {2, 0}, {1.5, 1.5, 0}, {1.33, 1.33, 1.33, 0}, {2, 2, 0, 0}, {0.6, 1.4}};
  for (const std::vector<double>& turn : shares)
    for (const double noise : {0.0, 0.05}) {
      std::mt19937 generator(2);
      std::normal_distribution<double> normal;
      std::size_t i = 0;
      const auto alternating = [&](double t) {
        return turn[i++ % turn.size()] * wave(t) + noise * normal(generator);
      };
      const TimeSeries rough = sampled(alternating, 0, 20, 0.02);
      const auto told = limits_of_all(rough).roughness;
      ASSERT_TRUE(told) << turn.size();
      for (const double size : {1e-200, 1e200}) {
        TimeSeries scaled = rough;
        for (double& value : scaled.value) value *= size;
        EXPECT_NEAR(limits_of_all(scaled).roughness.value_or(0), *told, 1e-9) << size;
      }
      const auto noisy = [&](double t) { return wave(t) + 4 * noise * normal(generator); };
      EXPECT_FALSE(limits_of_all(sampled(noisy, 0, 20, 0.02)).roughness) << noise;
    }
  EXPECT_FALSE(limits_of_all(sampled(wave, 0, 20, period / 8)).roughness);
}

// A part of a run that holds one crest, a part of its flat or of the readings still shows them.
TEST(SensorLimits, OfAPartOfTheRunAreThoseOfTheWholeRun) {
  const TimeSeries clipped =
      sampled([](double t) { return std::clamp(wave(t), -0.8, 0.8); }, 0, 20, 0.01);
  const auto first = std::find(clipped.value.begin() + 600, clipped.value.end(), 0.8);
  const double begin = 0.01 * static_cast<double>(first - clipped.value.begin());
  for (const TimeWindow part : {TimeWindow{begin - 0.1, begin + 0.5},
                                {begin - 0.8, begin + 0.2},
                                {begin + 0.02, begin + 0.1},
                                {begin + 0.1, begin + 0.9}}) {
    const SensorLimits found = sensor_limits(clipped, part);
    ASSERT_TRUE(found.highest) << part.begin << " " << part.end;
    EXPECT_EQ(found.highest->value, 0.8);
    EXPECT_LT(found.highest->begin, part.end);
    EXPECT_GT(found.highest->end, part.begin);
  }
  EXPECT_FALSE(sensor_limits(clipped, {begin - 0.4, begin - 0.1}).highest);  // no crest inside
  const TimeSeries held =
      sampled([](double t) { return wave(std::floor(t / 0.1) * 0.1); }, 0, 20, 0.01);
  EXPECT_TRUE(sensor_limits(held, {5, 5.5}).sparse);
  EXPECT_FALSE(sensor_limits(sampled(wave, 0, 20, 0.01), {5, 5.5}).sparse);
}

}  // namespace
}  // namespace slosh::sensor_limits_test
