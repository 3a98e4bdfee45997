// The tests use power laws in closed form: error = a cost^s at doubled resolutions.
#include "verification/convergence/work_precision.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace slosh::work_precision_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Bars {
  double cost = 0, error = 0;  // relative
};

// Runs with costs 1, 8, 64, ... and errors cost^slope.
std::vector<WorkPoint> power_law(double slope, int resolutions, Bars bars = {}) {
  std::vector<WorkPoint> points;
  for (int i = 0; i < resolutions; ++i) {
    const double cost = std::pow(8, i), error = std::pow(cost, slope);
    points.push_back({"run_" + std::to_string(i),
                      std::pow(2, i),
                      {cost, bars.cost * cost},
                      {error, bars.error * error}});
  }
  return points;
}

TEST(ParetoFront, LeavesOutWhatAnotherRunBeatsInBoth) {
  std::vector<WorkPoint> points = power_law(-0.5, 3);
  points.push_back({"dear", 1, {70, 0}, {0.5, 0}});
  points.push_back({"equal", 1, {8, 0}, {std::pow(8, -0.5), 0}});
  points.push_back({"same_error", 1, {9, 0}, {std::pow(8, -0.5), 0}});
  const auto front = pareto_front(points);
  ASSERT_EQ(front.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(front[i].cost.value, std::pow(8, i));
}

TEST(ParetoFront, LeavesOutWhatIsNoNumberOrNotAboveZero) {
  for (const double bad : {nan, 0.0, -1.0, std::numeric_limits<double>::infinity()}) {
    EXPECT_TRUE(pareto_front({{"cost", 1, {bad, 0}, {0.1, 0}}}).empty()) << bad;
    EXPECT_TRUE(pareto_front({{"error", 1, {1, 0}, {bad, 0}}}).empty()) << bad;
  }
}

TEST(WorkSlope, IsThatOfAPowerLaw) {
  const auto slope = work_slope(power_law(-0.4, 4));
  ASSERT_TRUE(slope);
  EXPECT_NEAR(slope->value, -0.4, 1e-12);
  EXPECT_NEAR(slope->half_width, 0, 1e-6);
}

TEST(WorkSlope, OfTwoResolutionsHasNoIntervalAndOfOneIsNone) {
  const auto slope = work_slope(power_law(-0.4, 2));
  ASSERT_TRUE(slope);
  EXPECT_NEAR(slope->value, -0.4, 1e-12);
  EXPECT_TRUE(std::isnan(slope->half_width));
  std::vector<WorkPoint> repeats = power_law(-0.4, 3);
  for (WorkPoint& point : repeats) point.resolution = 1;
  EXPECT_FALSE(work_slope(repeats));
}

// L = 0, -1, -1.8 at W = 0, 1, 2: slope -0.9, residuals -1/30, 1/15, -1/30, whose squares sum to
// 1/150; t of one degree of freedom is 12.7062 (tables).
TEST(WorkSlope, HasTheIntervalOfStudentsT) {
  const std::vector<WorkPoint> points{{"a", 1, {1, 0}, {1, 0}},
                                      {"b", 2, {std::exp(1), 0}, {std::exp(-1), 0}},
                                      {"c", 3, {std::exp(2), 0}, {std::exp(-1.8), 0}}};
  const auto slope = work_slope(points);
  ASSERT_TRUE(slope);
  EXPECT_NEAR(slope->value, -0.9, 1e-12);
  EXPECT_NEAR(slope->half_width, 12.7062 * std::sqrt(1.0 / 150 / 2), 1e-5);
}

TEST(WorkSlope, HoldsTheTruthInNineteenOfTwentyNoisySamples) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 0.1);
  int held = 0;
  constexpr int samples = 2000;
  for (int sample = 0; sample < samples; ++sample) {
    std::vector<WorkPoint> points = power_law(-0.4, 5);
    for (WorkPoint& point : points) point.error.value *= std::exp(noise(random));
    const Estimate slope = work_slope(points).value();
    held += std::abs(slope.value + 0.4) <= slope.half_width;
  }
  EXPECT_NEAR(held / static_cast<double>(samples), 0.95, 0.015);  // three standard errors
}

TEST(CostAtError, OfAPowerLawIsItsInverse) {
  const auto points = power_law(-0.4, 4);
  for (const double cost : {2.0, 8.0, 20.0, 500.0}) {
    const CostAtError found = cost_at_error(points, std::pow(cost, -0.4));
    EXPECT_EQ(found.reach, Reach::between);
    EXPECT_NEAR(found.cost / cost, 1, 1e-12);
  }
}

TEST(CostAtError, RestsOnTheRunsThatBracketIt) {
  const auto points = power_law(-0.5, 3);
  EXPECT_EQ(cost_at_error(points, std::pow(20, -0.5)).rests_on,
            (std::vector<std::string>{"run_1", "run_2"}));
  EXPECT_EQ(cost_at_error(points, points[1].error.value).rests_on,
            (std::vector<std::string>{"run_1"}));
  EXPECT_EQ(cost_at_error(points, 2).rests_on, (std::vector<std::string>{"run_0"}));
}

TEST(CostAtError, ThatTheCheapestRunUndercutsIsAtMostItsCost) {
  const CostAtError found = cost_at_error(power_law(-0.5, 3, {0.1, 0.2}), 1.5);
  EXPECT_EQ(found.reach, Reach::by_cheapest);
  EXPECT_EQ(found.cost, 1);
  EXPECT_NEAR(found.cost_spread, 0.1, 1e-12);
  EXPECT_EQ(found.error_spread, 0);  // ln 1.5 is beyond a bar of 0.2
}

TEST(CostAtError, IsUncertainWhereTheCheapestRunsBarReachesAcross) {
  const CostAtError found = cost_at_error(power_law(-0.5, 3, {0, 0.2}), 1.1);
  EXPECT_NEAR(found.error_spread, (0.2 - std::log(1.1)) / 0.5, 1e-12);
  // One run does not tell the cost of a smaller error.
  EXPECT_TRUE(std::isnan(cost_at_error(power_law(-0.5, 1, {0, 0.2}), 1.1).error_spread));
}

TEST(CostAtError, ThatNoRunReachesIsNoNumberAndTellsTheMostExact) {
  const CostAtError found = cost_at_error(power_law(-0.5, 3), 0.1);
  EXPECT_EQ(found.reach, Reach::not_at_all);
  EXPECT_TRUE(std::isnan(found.cost));
  ASSERT_TRUE(found.most_exact);
  EXPECT_EQ(found.most_exact->run, "run_2");
  const CostAtError of_none = cost_at_error({}, 0.1);
  EXPECT_EQ(of_none.reach, Reach::not_at_all);
  EXPECT_FALSE(of_none.most_exact);
}

TEST(CostAtError, OfNoNumberIsNotReached) {
  EXPECT_EQ(cost_at_error(power_law(-0.5, 3), nan).reach, Reach::not_at_all);
}

TEST(CostAtError, CarriesOnBothBars) {
  const auto points = power_law(-0.5, 2, {0.1, 0.2});
  const double middle = std::pow(8, -0.25);  // t = 1/2: each bar counts half, in quadrature
  const CostAtError found = cost_at_error(points, middle);
  EXPECT_NEAR(found.cost_spread, 0.1 / std::sqrt(2), 1e-12);
  EXPECT_NEAR(found.error_spread, 2 * 0.2 / std::sqrt(2), 1e-12);  // g = 1 / 0.5
  EXPECT_NEAR(known_spread(found), std::hypot(found.cost_spread, found.error_spread), 1e-15);
  const CostAtError at_second = cost_at_error(points, points[1].error.value);
  EXPECT_NEAR(at_second.cost_spread, 0.1, 1e-12);
  EXPECT_NEAR(at_second.error_spread, 0.4, 1e-12);
}

// Compares the standard deviation over noisy samples with the prediction from the bars of one.
TEST(CostAtError, HasTheSpreadThatNoisyRunsGive) {
  constexpr double noise_of_cost = 0.02, noise_of_error = 0.01;
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  const double error = std::pow(20, -0.5);
  double squares = 0;
  constexpr int samples = 4000;
  for (int sample = 0; sample < samples; ++sample) {
    std::vector<WorkPoint> points = power_law(-0.5, 3);
    for (WorkPoint& point : points) {
      point.cost.value *= std::exp(noise_of_cost * normal(random));
      point.error.value *= std::exp(noise_of_error * normal(random));
    }
    squares += std::pow(std::log(cost_at_error(points, error).cost / 20), 2);
  }
  const CostAtError predicted =
      cost_at_error(power_law(-0.5, 3, {noise_of_cost, noise_of_error}), error);
  EXPECT_NEAR(std::sqrt(squares / samples) / known_spread(predicted), 1, 0.05);
}

TEST(CostAtError, KnowsNoSpreadWhereARunsCostHasNone) {
  auto points = power_law(-0.5, 3, {0.1, 0.2});
  points[1].cost.half_width = nan;
  const CostAtError found = cost_at_error(points, std::pow(20, -0.5));
  EXPECT_TRUE(std::isnan(found.cost_spread));
  EXPECT_EQ(known_spread(found), found.error_spread);
  EXPECT_FALSE(std::isnan(cost_at_error(points, points[2].error.value).cost_spread));
}

TEST(CostBeyondTheMostExactRun, FollowsTheSlopeForAFactorOfTwo) {
  auto points = power_law(-0.5, 3, {0.1, 0.2});
  const double smallest = points.back().error.value;
  const CostAtError found = cost_at_error_or_beyond(points, smallest / 1.5);
  EXPECT_EQ(found.reach, Reach::extrapolated);
  EXPECT_NEAR(found.cost, 64 * 1.5 * 1.5, 1e-9);
  EXPECT_NEAR(found.cost_spread, 0.1, 1e-12);
  EXPECT_NEAR(found.error_spread, 0.4, 1e-6);  // the fit is exact
  EXPECT_EQ(cost_at_error_or_beyond(points, smallest / 2.1).reach, Reach::not_at_all);
  EXPECT_EQ(cost_at_error_or_beyond(points, smallest).reach, Reach::between);
}

TEST(CostBeyondTheMostExactRun, IsNotToldFromTwoResolutionsOrWithoutASlopeThatFalls) {
  EXPECT_EQ(cost_at_error_or_beyond(power_law(-0.5, 2), 0.3).reach, Reach::not_at_all);
  std::vector<WorkPoint> scattered = power_law(-0.5, 4);
  scattered[1].error.value = 3;
  scattered[2].error.value = 0.05;
  EXPECT_EQ(cost_at_error_or_beyond(scattered, 0.04).reach, Reach::not_at_all);
}

}  // namespace
}  // namespace slosh::work_precision_test
