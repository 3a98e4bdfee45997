#include "verification/gate/three_way_verdict.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace slosh::three_way_verdict_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr AllowedRange within_5_percent{-0.05, 0.05};

ThreeWayVerdict verdict(double error, double uncertainty, AllowedRange allowed = within_5_percent) {
  return judge_error(error, {.discretisation = uncertainty}, allowed).verdict;
}

TEST(ValidationUncertainty, AddsItsContributionsInQuadratureAndNamesTheDominantOne) {
  EXPECT_DOUBLE_EQ(validation_uncertainty({0.02, 0.04, 0.05, 0.06}), 0.09);
  EXPECT_EQ(validation_uncertainty({}), 0);
  EXPECT_TRUE(std::isnan(validation_uncertainty({.input = -0.01})));
  EXPECT_TRUE(std::isnan(validation_uncertainty({.time_series = nan})));
  EXPECT_EQ(dominant_contribution({0.4, 0.1, 0.2, 0.3}), "discretisation");
  EXPECT_EQ(dominant_contribution({0.1, 0.4, 0.2, 0.3}), "time series");
  EXPECT_EQ(dominant_contribution({0.1, 0.2, 0.4, 0.3}), "input");
  EXPECT_EQ(dominant_contribution({0.1, 0.2, 0.3, 0.4}), "reference");
}

TEST(ThreeWayVerdict, PassesOrFailsWhereTheWholeIntervalIsWithinOrBeyondTheBounds) {
  using enum ThreeWayVerdict;
  constexpr AllowedRange decay{0.01, 0.03}, at_least{2, infinity}, at_most{-infinity, 2};
  const struct {
    double error, uncertainty;
    ThreeWayVerdict verdict;
    AllowedRange allowed = within_5_percent;
  } judged[] = {{0.02, 0.02, pass},
                {0.02, 0.0299, pass},
                {0.05, 0, pass},
                {0.08, 0.0299, fail},
                {0.0501, 0, fail},
                {0.02, 0.0301, inconclusive},
                {0.08, 0.0301, inconclusive},
                {0.05, 1e-9, inconclusive},
                {0, 10, inconclusive},
                {0.02, 0.009, pass, decay},
                {0.012, 0.003, inconclusive, decay},
                {0.028, 0.003, inconclusive, decay},
                {0.005, 0.004, fail, decay},
                {0.035, 0.004, fail, decay},
                {1e9, 1, pass, at_least},
                {2.5, 1, inconclusive, at_least},
                {0, 1, fail, at_least},
                {-1e9, 1, pass, at_most},
                {3.5, 1, fail, at_most}};
  for (const auto& [error, uncertainty, expected, allowed] : judged) {
    EXPECT_EQ(verdict(error, uncertainty, allowed), expected) << error;
    EXPECT_EQ(verdict(-error, uncertainty, {-allowed.upper, -allowed.lower}), expected) << -error;
  }
}

TEST(ThreeWayVerdict, FailsWhatIsNoNumber) {
  for (const double error : {nan, infinity, -infinity}) {
    for (const double uncertainty : {0.0, 0.01, infinity, nan})
      EXPECT_EQ(verdict(error, uncertainty), ThreeWayVerdict::fail);
    EXPECT_EQ(verdict(error, 0.01, {-infinity, infinity}), ThreeWayVerdict::fail);
  }
  EXPECT_EQ(verdict(0, 0, {nan, 0.05}), ThreeWayVerdict::fail);
  EXPECT_EQ(verdict(0, 0, {-0.05, nan}), ThreeWayVerdict::fail);
  EXPECT_EQ(verdict(0, 0, {0.05, -0.05}), ThreeWayVerdict::fail);
}

TEST(ThreeWayVerdict, NeverPassesOrFailsByAnUncertaintyThatIsNoNumber) {
  for (const double uncertainty : {nan, infinity, -0.01}) {
    EXPECT_EQ(verdict(0, uncertainty), ThreeWayVerdict::inconclusive);
    EXPECT_EQ(verdict(10, uncertainty), ThreeWayVerdict::inconclusive);
    EXPECT_FALSE(finer_step(judge_error(0, {.discretisation = uncertainty}, within_5_percent), 1));
  }
}

TEST(ThreeWayVerdict, TellsTheUncertaintyThatWouldBeConclusive) {
  EXPECT_NEAR(judge_error(-0.02, {0.09}, within_5_percent).conclusive_uncertainty, 0.03, 1e-15);
  EXPECT_NEAR(judge_error(0.07, {0.09}, within_5_percent).conclusive_uncertainty, 0.02, 1e-15);
  EXPECT_EQ(judge_error(0.05, {0.09}, within_5_percent).conclusive_uncertainty, 0);
  EXPECT_TRUE(std::isnan(judge_error(nan, {0.09}, within_5_percent).conclusive_uncertainty));
}

// E = 0.01 and |E| <= 0.06 leave 0.05; beside 0.03 of input that is 0.04 for one more.
const UncertaintyContributions coarse{.discretisation = 0.16, .input = 0.03};
const UncertaintyContributions brief{.time_series = 0.16, .input = 0.03};
constexpr AllowedRange within_6_percent{-0.06, 0.06};

TEST(FinerStep, IsTheRatioThatLeavesTheUncertaintyItsRoomBesideTheOthers) {
  const auto outcome = judge_error(0.01, coarse, within_6_percent);
  EXPECT_EQ(outcome.verdict, ThreeWayVerdict::inconclusive);
  const auto second_order = finer_step(outcome, 2), first_order = finer_step(outcome, 1),
             to_failure = finer_step(judge_error(0.11, coarse, within_6_percent), 2);
  ASSERT_TRUE(second_order && first_order && to_failure);
  EXPECT_NEAR(second_order->half_width, 0.04, 1e-12);
  EXPECT_NEAR(second_order->factor, 2, 1e-12);
  EXPECT_NEAR(second_order->cost_ratio, 8, 1e-11);
  EXPECT_NEAR(first_order->factor, 4, 1e-12);
  EXPECT_NEAR(first_order->cost_ratio, 64, 1e-10);
  const auto refined = [](double error, double half_width) {
    auto contributions = coarse;
    contributions.discretisation = 0.999 * half_width;
    return judge_error(error, contributions, within_6_percent).verdict;
  };
  EXPECT_EQ(refined(0.01, second_order->half_width), ThreeWayVerdict::pass);
  EXPECT_EQ(refined(0.11, to_failure->half_width), ThreeWayVerdict::fail);
}

TEST(LongerWindow, CountsTheSquareOfTheRatio) {
  const auto remedy = longer_window(judge_error(-0.01, brief, within_6_percent));
  ASSERT_TRUE(remedy);
  EXPECT_NEAR(remedy->half_width, 0.04, 1e-12);
  EXPECT_NEAR(remedy->factor, 16, 1e-10);
  EXPECT_NEAR(remedy->cost_ratio, 16, 1e-10);
}

TEST(Remedies, AreNoneWhereTheOthersLeaveNoRoomOrNoneIsNeededOrNoOrderIsKnown) {
  const auto judged = [](double error, const UncertaintyContributions& contributions) {
    return judge_error(error, contributions, within_6_percent);
  };
  EXPECT_FALSE(longer_window(judged(0.01, coarse)));
  EXPECT_FALSE(finer_step(judged(0.01, brief), 2));
  EXPECT_FALSE(finer_step(judged(0.03, coarse), 2));  // input is 0.03 alone
  EXPECT_FALSE(finer_step(judged(0.06, coarse), 2));  // on the bound
  EXPECT_FALSE(finer_step(judged(0.01, {0.01}), 2));
  EXPECT_FALSE(longer_window(judged(1, {.time_series = 0.01})));
  EXPECT_FALSE(finer_step(judged(nan, {0.01}), 2));
  for (const double order : {0.0, -1.0, nan}) EXPECT_FALSE(finer_step(judged(0.01, coarse), order));
}

}  // namespace
}  // namespace slosh::three_way_verdict_test
