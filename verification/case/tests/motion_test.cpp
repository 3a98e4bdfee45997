// The tank's motion: ramps and tables against finite differences and exact polynomials.
#include "verification/case/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "verification/case/motion/motion_times.hpp"

namespace slosh::motion_test {
namespace {

CaseDefinition moved_by(MotionDefinition motion) {
  CaseDefinition definition{};
  definition.motion = std::move(motion);
  return definition;
}

CaseDefinition surging(MotionHistory displacement) {
  return moved_by({.surge = std::move(displacement)});
}

CaseDefinition rolling(MotionHistory angle) {
  return moved_by({.roll = RollDefinition{std::move(angle), 0.45, -0.1}});
}

// Central differences with a step near the cube root of the rounding error.
double slope(const std::function<double(double)>& f, double t) {
  constexpr double step = 1e-5;
  return (f(t + step) - f(t - step)) / (2 * step);
}

void expect_consistent_derivatives(const SurgeMotion& motion, double from, double to,
                                   double scale) {
  for (double t = from; t <= to; t += 0.0137) {
    ASSERT_NEAR(motion.velocity(t), slope(motion.displacement, t), 1e-8 * scale) << t;
    ASSERT_NEAR(motion.acceleration(t), slope(motion.velocity, t), 1e-8 * scale) << t;
  }
}

constexpr double omega = 1.483464;
constexpr double period = 2 * std::numbers::pi / omega;

// sin(omega t) sampled at irregular times, dense enough for a spline.
TableMotion irregular_sine() {
  TableMotion table;
  for (double t = 0; t < 10; t += 0.03 + 0.02 * std::sin(7 * t)) {
    table.time.push_back(t);
    table.value.push_back(std::sin(omega * t));
  }
  return table;
}

TEST(StillMotion, IsNone) {
  const SurgeMotion motion = surge_motion(moved_by({}));
  for (const double t : {0.0, 0.3, 1e6}) {
    EXPECT_EQ(motion.displacement(t), 0);
    EXPECT_EQ(motion.velocity(t), 0);
    EXPECT_EQ(motion.acceleration(t), 0);
  }
  EXPECT_EQ(forcing_frequency(moved_by({})), 0);
}

TEST(SineMotionOfASurge, HasExactDerivatives) {
  const SurgeMotion motion = surge_motion(surging(SineMotion{0.02, omega}));
  EXPECT_EQ(motion.displacement(0), 0);
  EXPECT_EQ(motion.velocity(0), 0.02 * omega);
  EXPECT_EQ(motion.acceleration(0), 0);
  EXPECT_NEAR(motion.displacement(period / 4), 0.02, 1e-15);
  expect_consistent_derivatives(motion, 0, 20, 1);
}

TEST(RampedSineMotion, JoinsTheSineSmoothlyWhereTheRampEnds) {
  const SurgeMotion ramped = surge_motion(surging(SineMotion{0.02, omega, 1.75}));
  const SurgeMotion sine = surge_motion(surging(SineMotion{0.02, omega}));
  for (double t : {1.75 * period - 1e-9, 1.75 * period + 1e-9, 3 * period}) {
    EXPECT_NEAR(ramped.displacement(t), sine.displacement(t), 1e-9);
    EXPECT_NEAR(ramped.velocity(t), sine.velocity(t), 1e-9);
    EXPECT_NEAR(ramped.acceleration(t), sine.acceleration(t), 1e-9);
  }
  EXPECT_GT(std::abs(ramped.displacement(period / 4) - sine.displacement(period / 4)), 0.015);
}

TEST(SineMotionOfASurge, StartsWhereItsPhaseSays) {
  const double phase = std::numbers::pi / 2;  // a cosine
  const SurgeMotion motion = surge_motion(surging(SineMotion{0.02, omega, 0, phase}));
  EXPECT_DOUBLE_EQ(motion.displacement(0), 0.02);
  EXPECT_NEAR(motion.velocity(0), 0, 1e-17);
  EXPECT_DOUBLE_EQ(motion.acceleration(0), -0.02 * omega * omega);
  expect_consistent_derivatives(motion, 0, 20, 1);
}

TEST(RampedSineMotion, StartsAtRestWithAnyPhaseAndAsASineWithoutAJerk) {
  for (const double phase : {0.0, 1.1}) {
    const SurgeMotion motion = surge_motion(surging(SineMotion{0.02, omega, 2, phase}));
    EXPECT_EQ(motion.displacement(0), 0);
    EXPECT_EQ(motion.velocity(0), 0);
    EXPECT_EQ(motion.acceleration(0), 0);
    EXPECT_NEAR(motion.displacement(5 * period), 0.02 * std::sin(phase), 1e-15);
    expect_consistent_derivatives(motion, 0.1, 20, 1);
  }
  const SurgeMotion sine = surge_motion(surging(SineMotion{0.02, omega, 2}));
  EXPECT_NEAR(sine.acceleration(1e-6), 0, 1e-9);
}

TEST(SumOfSines, IsTheSumOfItsSinesAndOfTheirDerivatives) {
  const SineMotion one{0.02, omega, 0, 0.3}, two{0.005, 2.7 * omega, 1.5, -1.2};
  const SurgeMotion sum = surge_motion(surging(SumOfSines{{one, two}})),
                    first = surge_motion(surging(one)), second = surge_motion(surging(two));
  for (double t = 0; t < 20; t += 0.37) {
    EXPECT_DOUBLE_EQ(sum.displacement(t), first.displacement(t) + second.displacement(t));
    EXPECT_DOUBLE_EQ(sum.velocity(t), first.velocity(t) + second.velocity(t));
    EXPECT_DOUBLE_EQ(sum.acceleration(t), first.acceleration(t) + second.acceleration(t));
  }
  expect_consistent_derivatives(sum, 0.1, 20, 1);
}

TEST(TableMotionOfASurge, PassesThroughItsPointsAndFollowsTheSampledFunctionBetweenThem) {
  const TableMotion table = irregular_sine();
  const SurgeMotion motion = surge_motion(surging(table));
  expect_consistent_derivatives(motion, 0.001, 9.5, 1);
  for (std::size_t i = 0; i < table.time.size(); ++i)
    EXPECT_NEAR(motion.displacement(table.time[i]), table.value[i], 1e-14);
  for (double t = 0; t < 9.9; t += 0.011) {
    // Spacing 0.05 at most: errors of order spacing^4, ^3 and ^2.
    ASSERT_NEAR(motion.displacement(t), std::sin(omega * t), 1e-6);
    ASSERT_NEAR(motion.velocity(t), omega * std::cos(omega * t), 1e-4);
    ASSERT_NEAR(motion.acceleration(t), -omega * omega * std::sin(omega * t), 1e-2);
  }
}

TEST(TableMotionOfASurge, HasAContinuousSecondDerivativeAtItsPoints) {
  TableMotion rough{.file = {}, .time = {0, 1, 1.5, 3, 3.2, 4}, .value = {0, 2, -1, 0, 3, 1}};
  const SurgeMotion motion = surge_motion(surging(rough));
  for (double t : {1.0, 1.5, 3.0, 3.2}) {
    constexpr double beside = 1e-9;
    EXPECT_NEAR(motion.velocity(t - beside), motion.velocity(t + beside), 1e-6);
    EXPECT_NEAR(motion.acceleration(t - beside), motion.acceleration(t + beside), 1e-5);
  }
}

TEST(TableMotionOfASurge, ReproducesACubicExactlyFromFourPoints) {
  const auto cubic = [](double t) { return 0.3 - t + 0.5 * t * t - 0.2 * t * t * t; };
  for (std::vector<double> times :
       {std::vector<double>{0, 0.3, 1.1, 2}, {0, 0.5, 0.6, 1.5, 1.7, 2}}) {
    TableMotion table{.file = {}, .time = times, .value = {}};
    for (double t : times) table.value.push_back(cubic(t));
    const SurgeMotion motion = surge_motion(surging(table));
    for (double t = 0; t <= 2.1; t += 0.1) {  // a little beyond the end too
      EXPECT_NEAR(motion.displacement(t), cubic(t), 1e-13);
      EXPECT_NEAR(motion.velocity(t), -1 + t - 0.6 * t * t, 1e-12);
      EXPECT_NEAR(motion.acceleration(t), 1 - 1.2 * t, 1e-12);
    }
  }
}

TEST(RollMotion, IsNoneOfATankThatDoesNotRoll) {
  EXPECT_FALSE(roll_motion(moved_by({})));
  EXPECT_FALSE(roll_motion(surging(SineMotion{0.02, omega})));
}

TEST(RollMotion, HasItsAxisAndExactDerivatives) {
  const auto roll = roll_motion(rolling(SineMotion{0.07, omega, 2}));
  ASSERT_TRUE(roll);
  EXPECT_EQ(roll->axis_x, 0.45);
  EXPECT_EQ(roll->axis_z, -0.1);
  expect_consistent_derivatives({roll->angle, roll->rate, roll->acceleration}, 0.1, 20, 1);
}

TEST(RollMotion, GoesTogetherWithASurge) {
  CaseDefinition both = rolling(irregular_sine());
  both.motion.surge = SineMotion{0.02, 2 * omega};
  EXPECT_NEAR(roll_motion(both)->angle(1.1), std::sin(1.1 * omega), 1e-6);
  EXPECT_DOUBLE_EQ(surge_motion(both).displacement(1.1), 0.02 * std::sin(2.2 * omega));
  EXPECT_EQ(surge_motion(rolling(irregular_sine())).displacement(1.1), 0);
}

TEST(ForcedModes, AreOneForEachFrequencyInTheOrderOfTheMotions) {
  CaseDefinition both = rolling(SumOfSines{{SineMotion{0.07, 3}, SineMotion{0.01, omega}}});
  both.motion.surge = SumOfSines{{SineMotion{0.02, omega}, SineMotion{0.01, 5}}};
  const std::vector<ForcedMode> modes = forced_modes(both);
  ASSERT_EQ(modes.size(), 3u);
  EXPECT_EQ(modes[0].name, "forced_1");
  EXPECT_EQ(modes[0].angular_frequency, omega);
  EXPECT_EQ(modes[1].name, "forced_2");
  EXPECT_EQ(modes[1].angular_frequency, 5);
  EXPECT_EQ(modes[2].name, "forced_3");
  EXPECT_EQ(modes[2].angular_frequency, 3);
  EXPECT_EQ(forcing_frequency(both), 0);
}

TEST(ForcedModes, OfATableBesideASineAreTheDeclaredOneAndTheSines) {
  CaseDefinition both = rolling(irregular_sine());
  both.motion.surge = SineMotion{0.02, omega};
  ASSERT_EQ(forced_modes(both).size(), 1u);
  EXPECT_EQ(forced_modes(both)[0].name, "forced");
  both.declared_forcing_frequency = 3.84;
  ASSERT_EQ(forced_modes(both).size(), 2u);
  EXPECT_EQ(forced_modes(both)[1].angular_frequency, 3.84);
}

TEST(ForcedModes, AreKnownByTheirNames) {
  EXPECT_TRUE(is_forced("forced"));
  EXPECT_TRUE(is_forced("forced_2"));
  EXPECT_FALSE(is_forced("natural_1"));
  EXPECT_FALSE(is_forced("whole"));
}

TEST(ForcingFrequency, IsThatOfTheSineWhichTheMotionsShareOrWhatTheCaseDeclaresOfATable) {
  EXPECT_EQ(forcing_frequency(surging(SineMotion{0.02, omega})), omega);
  EXPECT_EQ(forcing_frequency(rolling(SineMotion{0.07, 2})), 2);
  CaseDefinition nearly_a_sine = rolling(irregular_sine());
  EXPECT_EQ(forcing_frequency(nearly_a_sine), 0);
  nearly_a_sine.declared_forcing_frequency = 3.84;
  EXPECT_EQ(forcing_frequency(nearly_a_sine), 3.84);
  CaseDefinition both = rolling(SineMotion{0.07, omega});
  both.motion.surge = SineMotion{0.02, omega};
  EXPECT_EQ(forcing_frequency(both), omega);
  both.motion.surge = SineMotion{0.02, 2 * omega};
  EXPECT_EQ(forcing_frequency(both), 0);
}

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
}  // namespace slosh::motion_test
