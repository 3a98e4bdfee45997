#include "verification/case/motion/motion_times.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "verification/case/motion.hpp"

namespace slosh::motion_times_test {
namespace {

double position(double t) { return std::sin(3 * t) + 0.1 * t * t; }

TableMotion table_of(const std::vector<double>& times) {
  TableMotion table{"motion.csv", times, {}};
  for (const double t : times) table.value.push_back(position(t));
  return table;
}

std::vector<double> at_rate(double rate, double last) {
  std::vector<double> times;
  for (int i = 0; i <= std::lround(last * rate); ++i) times.push_back(i / rate);
  return times;
}

CaseDefinition surging(const MotionHistory& surge, double duration) {
  CaseDefinition definition{};
  definition.motion.surge = surge;
  definition.duration = duration;
  return definition;
}

TEST(ThinnedTable, KeepsATableThatIsCoarseEnough) {
  for (const double rate : {100.0, 500.0}) {
    const TableMotion table = table_of(at_rate(rate, 3)), kept = thinned(table, 2e-3);
    EXPECT_EQ(kept.time, table.time) << rate;
    EXPECT_EQ(kept.value, table.value) << rate;
  }
}

TEST(ThinnedTable, KeepsPointsOfAFineTableAndItsEnd) {
  const TableMotion kept = thinned(table_of(at_rate(20000, 1.0017)), 2e-3);
  EXPECT_EQ(kept.time.front(), 0);
  EXPECT_DOUBLE_EQ(kept.time.back(), 1.0017);
  for (std::size_t i = 1; i < kept.time.size(); ++i) {
    EXPECT_GE(kept.time[i] - kept.time[i - 1], 2e-3 * (1 - 1e-6));
    EXPECT_LT(kept.time[i] - kept.time[i - 1], 4e-3);
    EXPECT_EQ(kept.value[i], position(kept.time[i]));
  }
}

TEST(ThinnedTable, StartsAtZeroWhereTheTableStartsBefore) {
  const TableMotion kept = thinned(table_of({-0.03, -0.02, -0.01, 0.005, 0.015, 0.025, 1}), 2e-3);
  EXPECT_EQ(kept.time, (std::vector<double>{0, 0.005, 0.015, 0.025, 1}));
  EXPECT_NEAR(kept.value.front(), 0, 1e-4);
}

TEST(ThinnedTable, LeavesASplineItsPoints) {
  const std::vector<double> times{0, 0.0005, 0.001, 20};
  EXPECT_EQ(thinned(table_of(times), 2e-3).time, times);
}

TEST(MotionTimes, AreStepsOfASine) {
  const auto times = motion_times(surging(SineMotion{0.1, 3}, 0.5), 0.2);
  EXPECT_EQ(times, (std::vector<double>{0, 0.2, 0.4, 0.5}));
  EXPECT_TRUE(motion_knots(SineMotion{0.1, 3}, 0.5).empty());
}

TEST(MotionTimes, HaveThePointsOfEveryTable) {
  CaseDefinition definition = surging(table_of({0, 0.3, 0.45, 0.7}), 0.5);
  definition.motion.roll = RollDefinition{table_of({0, 0.1, 0.3, 0.7}), 0, 0};
  const auto times = motion_times(definition, 0.125);
  const std::vector<double> expected{0, 0.1, 0.225, 0.3, 0.425, 0.45, 0.5};
  ASSERT_EQ(times.size(), expected.size());
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_DOUBLE_EQ(times[i], expected[i]);
}

// A time offset leaves a table's points beside those of another by rounding.
TEST(MotionTimes, TakePointsThatDifferByRoundingAsOne) {
  CaseDefinition definition = surging(table_of(at_rate(100, 1)), 1);
  std::vector<double> shifted;
  for (const double t : at_rate(100, 2)) shifted.push_back(t + 1.3 - 1.3);
  definition.motion.roll = RollDefinition{table_of(shifted), 0, 0};
  const auto times = motion_times(definition, 0.01);
  EXPECT_EQ(times.size(), 101u);
  for (std::size_t i = 1; i < times.size(); ++i) EXPECT_GT(times[i] - times[i - 1], 0.009);
}

// Straight lines through the acceleration at the steps give the positions at the steps.
TEST(TablesReadAtSteps, KeepThePositionsAndTheMeansOfTheAcceleration) {
  TableMotion noisy = table_of(at_rate(1000, 1));
  for (std::size_t i = 0; i < noisy.value.size(); ++i)
    noisy.value[i] = std::round(1e4 * noisy.value[i]) / 1e4;
  constexpr double step = 0.01;
  const CaseDefinition definition = surging(noisy, 1);
  const SurgeMotion read = surge_motion(with_tables_at(definition, step));
  const SurgeMotion whole = surge_motion(definition);
  double position = read.displacement(0), velocity = read.velocity(0);
  for (int i = 0; i < 100; ++i) {
    const double a = read.acceleration(i * step), b = read.acceleration((i + 1) * step);
    position += step * velocity + step * step * (2 * a + b) / 6;
    velocity += step * (a + b) / 2;
    EXPECT_NEAR(position, whole.displacement((i + 1) * step), 1e-9);
  }
  const MotionHistory sine = SineMotion{0.1, 3};
  EXPECT_EQ(std::get<SineMotion>(*with_tables_at(surging(sine, 1), step).motion.surge).amplitude,
            0.1);
}

}  // namespace
}  // namespace slosh::motion_times_test
