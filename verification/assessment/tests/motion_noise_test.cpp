#include "verification/assessment/doubts/motion_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "verification/assessment/tests/found_limit.hpp"
#include "verification/case/motion/motion_times.hpp"

namespace slosh::motion_noise_test {
namespace {

constexpr double omega = 2 * std::numbers::pi * 0.9, length = 10;

// A sine of 1, written with a step of its last digit, or without rounding for 0.
TableMotion sine_table(double rate, double digit) {
  TableMotion table{"record.csv", {}, {}};
  for (int i = 0; i <= std::lround(length * rate); ++i) {
    const double t = i / rate, value = std::sin(omega * t);
    table.time.push_back(t);
    table.value.push_back(digit > 0 ? digit * std::round(value / digit) : value);
  }
  return table;
}

std::vector<ModelLimit> limits_of(const TableMotion& table) {
  CaseDefinition definition = case_with_runs({});
  definition.motion.surge = table;
  return motion_noise(definition);
}

ModelLimit limit_of(const TableMotion& table) { return limits_of(table).at(0); }

double number_after(const std::string& words, const ModelLimit& limit) {
  return std::stod(limit.effect.substr(limit.effect.find(words) + words.size()));
}

TEST(MotionNoise, IsSmallForASmoothMotionAtAnyRateAStopOfTheTankAndATankAtRest) {
  for (const double rate : {12.0, 25.0, 100.0, 500.0})
    EXPECT_LT(limit_of(sine_table(rate, 0)).value, 0.05) << rate;
  TableMotion stop{"stop.csv", {}, {}}, rest = stop;
  for (int i = 0; i <= 200; ++i) {
    stop.time.push_back(0.05 * i);
    stop.value.push_back(std::min(0.05 * i, 4.0));
    rest.time.push_back(0.05 * i);
    rest.value.push_back(0);
  }
  EXPECT_FALSE(limit_of(stop).exceeded());
  EXPECT_EQ(limit_of(rest).value, 0);
}

// Against the acceleration of noise of a known size, by the formula of a cubic spline.
TEST(MotionNoise, IsSixTimesTheScatterOverTheIntervalSquared) {
  std::mt19937 random(1);
  for (const double scatter : {3e-5, 1e-4}) {
    TableMotion table = sine_table(200, 0);
    std::normal_distribution<double> noise(0, scatter);
    for (double& value : table.value) value += noise(random);
    const double of_noise = 6 * scatter * 200 * 200, of_sine = omega * omega / std::sqrt(2);
    EXPECT_NEAR(limit_of(table).value, of_noise / std::hypot(of_noise, of_sine), 0.1);
  }
}

TEST(MotionNoise, DoubtsATableOfFewDigitsAndSaysWhatWouldDo) {
  CaseDefinition definition = case_with_runs({});
  definition.motion.surge = sine_table(500, 1e-3);
  const auto limit = found_limit(definition, "the noise of motion.surge");
  ASSERT_TRUE(limit);
  EXPECT_TRUE(limit->exceeded());
  EXPECT_GT(limit->value, 0.9);
  EXPECT_NEAR(number_after("record.csv scatters by ", *limit), 1e-3 / std::sqrt(12), 3e-5);
  EXPECT_EQ(number_after("m at points ", *limit), 0.002);
  // What it says would do does.
  const TableMotion sparse =
      thinned(sine_table(500, 1e-3), 1.05 * number_after("apart; points ", *limit));
  EXPECT_LT(limit_of(sparse).value, 0.12);
  EXPECT_FALSE(limit_of(sine_table(500, 1e-8)).exceeded());
  EXPECT_NE(limit_of(sine_table(100, 0.5)).effect.find("no smoothing of it"), std::string::npos);
  EXPECT_EQ(limit_text({"noise", 1, 0.5, "of it", "source"}),
            "noise: 100 % of it, limit 50 % (source)");
  EXPECT_EQ(limit_text({"noise", 0.996, 0.079, "of it", "source"}),
            "noise: 100 % of it, limit 7.9 % (source)");
}

TEST(MotionNoise, DoubtsNaNAndPositionsAloneOfMoreThanAFewPoints) {
  TableMotion poisoned = sine_table(100, 0), braking = sine_table(100, 1e-2);
  poisoned.value[200] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(limit_of(poisoned).exceeded());
  EXPECT_TRUE(limit_of(braking).exceeded());
  braking.of_accelerations = true;
  EXPECT_TRUE(limits_of(braking).empty());
  EXPECT_TRUE(motion_noise(case_with_runs({})).empty()) << "of sines";
  EXPECT_TRUE(limits_of({"few.csv", {0, 1, 2, 3}, {0, 1, 0, 1}}).empty());
}

TEST(MotionNoise, OfARollIsInDegrees) {
  CaseDefinition definition = case_with_runs({});
  TableMotion table = sine_table(500, 1e-3);
  for (double& value : table.value) value *= std::numbers::pi / 180;
  definition.motion.surge.reset();
  definition.motion.roll = RollDefinition{table, 0.5, 0};
  const auto limit = found_limit(definition, "the noise of motion.roll");
  ASSERT_TRUE(limit);
  EXPECT_NEAR(number_after("scatters by ", *limit), 1e-3 / std::sqrt(12), 3e-5);
  EXPECT_NE(limit->effect.find(" deg at points"), std::string::npos) << limit->effect;
}

}  // namespace
}  // namespace slosh::motion_noise_test
