#include "verification/gate/three_way_verdict.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "verification/metrics/comparison.hpp"
#include "verification/tests/synthetic_series.hpp"

namespace slosh::three_way_verdict_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr AllowedRange within_5_percent{-0.05, 0.05};

ThreeWayVerdict verdict(double error, double uncertainty, AllowedRange allowed = within_5_percent) {
  return judge_error(error, {.discretisation = uncertainty}, allowed).verdict;
}

TEST(ValidationUncertainty, AddsItsContributionsInQuadrature) {
  EXPECT_DOUBLE_EQ(validation_uncertainty({0.02, 0.04, 0.05, 0.06}), 0.09);
  EXPECT_EQ(validation_uncertainty({}), 0);
  EXPECT_TRUE(std::isnan(validation_uncertainty({.input = -0.01})));
  EXPECT_TRUE(std::isnan(validation_uncertainty({.time_series = nan})));
}

TEST(ValidationUncertainty, NamesItsDominantContribution) {
  EXPECT_EQ(dominant_contribution({0.4, 0.1, 0.2, 0.3}), "discretisation");
  EXPECT_EQ(dominant_contribution({0.1, 0.4, 0.2, 0.3}), "time series");
  EXPECT_EQ(dominant_contribution({0.1, 0.2, 0.4, 0.3}), "input");
  EXPECT_EQ(dominant_contribution({0.1, 0.2, 0.3, 0.4}), "reference");
}

TEST(ThreeWayVerdict, PassesWhereTheWholeIntervalIsWithinTheLimit) {
  for (const double sign : {-1, 1}) {
    EXPECT_EQ(verdict(sign * 0.02, 0.02), ThreeWayVerdict::pass);
    EXPECT_EQ(verdict(sign * 0.02, 0.0299), ThreeWayVerdict::pass);
    EXPECT_EQ(verdict(sign * 0.05, 0), ThreeWayVerdict::pass);
  }
}

TEST(ThreeWayVerdict, FailsWhereTheWholeIntervalIsBeyondTheLimit) {
  for (const double sign : {-1, 1}) {
    EXPECT_EQ(verdict(sign * 0.08, 0.0299), ThreeWayVerdict::fail);
    EXPECT_EQ(verdict(sign * 0.0501, 0), ThreeWayVerdict::fail);
  }
}

TEST(ThreeWayVerdict, IsInconclusiveWhereTheIntervalHoldsTheLimit) {
  for (const double sign : {-1, 1}) {
    EXPECT_EQ(verdict(sign * 0.02, 0.0301), ThreeWayVerdict::inconclusive);
    EXPECT_EQ(verdict(sign * 0.08, 0.0301), ThreeWayVerdict::inconclusive);
    EXPECT_EQ(verdict(sign * 0.05, 1e-9), ThreeWayVerdict::inconclusive);
  }
  EXPECT_EQ(verdict(0, 10), ThreeWayVerdict::inconclusive);
}

TEST(ThreeWayVerdict, JudgesARangeFromTheNearerOfItsBounds) {
  const AllowedRange decay{0.01, 0.03};
  EXPECT_EQ(verdict(0.02, 0.009, decay), ThreeWayVerdict::pass);
  EXPECT_EQ(verdict(0.012, 0.003, decay), ThreeWayVerdict::inconclusive);
  EXPECT_EQ(verdict(0.028, 0.003, decay), ThreeWayVerdict::inconclusive);
  EXPECT_EQ(verdict(0.005, 0.004, decay), ThreeWayVerdict::fail);
  EXPECT_EQ(verdict(0.035, 0.004, decay), ThreeWayVerdict::fail);
}

TEST(ThreeWayVerdict, JudgesARangeWithOneBound) {
  const AllowedRange at_least{2, infinity}, at_most{-infinity, 2};
  EXPECT_EQ(verdict(1e9, 1, at_least), ThreeWayVerdict::pass);
  EXPECT_EQ(verdict(2.5, 1, at_least), ThreeWayVerdict::inconclusive);
  EXPECT_EQ(verdict(0, 1, at_least), ThreeWayVerdict::fail);
  EXPECT_EQ(verdict(-1e9, 1, at_most), ThreeWayVerdict::pass);
  EXPECT_EQ(verdict(3.5, 1, at_most), ThreeWayVerdict::fail);
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
  const auto second_order = finer_step(outcome, 2), first_order = finer_step(outcome, 1);
  ASSERT_TRUE(second_order && first_order);
  EXPECT_NEAR(second_order->half_width, 0.04, 1e-12);
  EXPECT_NEAR(second_order->factor, 2, 1e-12);
  EXPECT_NEAR(second_order->cost_ratio, 8, 1e-11);
  EXPECT_NEAR(first_order->factor, 4, 1e-12);
  EXPECT_NEAR(first_order->cost_ratio, 64, 1e-10);
  auto refined = coarse;
  refined.discretisation = 0.999 * second_order->half_width;
  EXPECT_EQ(judge_error(0.01, refined, within_6_percent).verdict, ThreeWayVerdict::pass);
}

TEST(FinerStep, CanAlsoLeadToAFailure) {
  const auto remedy = finer_step(judge_error(0.11, coarse, within_6_percent), 2);
  ASSERT_TRUE(remedy);
  auto refined = coarse;
  refined.discretisation = 0.999 * remedy->half_width;
  EXPECT_EQ(judge_error(0.11, refined, within_6_percent).verdict, ThreeWayVerdict::fail);
}

TEST(LongerWindow, CountsTheSquareOfTheRatio) {
  const auto remedy = longer_window(judge_error(-0.01, brief, within_6_percent));
  ASSERT_TRUE(remedy);
  EXPECT_NEAR(remedy->half_width, 0.04, 1e-12);
  EXPECT_NEAR(remedy->factor, 16, 1e-10);
  EXPECT_NEAR(remedy->cost_ratio, 16, 1e-10);
}

TEST(Remedies, AreNoneWhereTheOtherContributionsLeaveNoRoom) {
  EXPECT_FALSE(longer_window(judge_error(0.01, coarse, within_6_percent)));
  EXPECT_FALSE(finer_step(judge_error(0.01, brief, within_6_percent), 2));
  EXPECT_FALSE(finer_step(judge_error(0.03, coarse, within_6_percent), 2));  // input is 0.03 alone
  EXPECT_FALSE(finer_step(judge_error(0.06, coarse, within_6_percent), 2));  // on the bound
}

TEST(Remedies, AreNoneWhereNoneIsNeededOrNoOrderIsKnown) {
  EXPECT_FALSE(finer_step(judge_error(0.01, {0.01}, within_6_percent), 2));
  EXPECT_FALSE(longer_window(judge_error(1, {.time_series = 0.01}, within_6_percent)));
  EXPECT_FALSE(finer_step(judge_error(nan, {0.01}, within_6_percent), 2));
  for (const double order : {0.0, -1.0, nan})
    EXPECT_FALSE(finer_step(judge_error(0.01, coarse, within_6_percent), order));
}

// The verdict on a candidate's forced mode against the same wave as reference.
class VerdictOnSeries : public ::testing::Test {
 protected:
  static constexpr double frequency = 1.5;  // [rad/s]

  static TimeSeries wave(double scale = 1, double lag = 0, double end = 20) {
    return sampled([=](double t) { return 0.01 * scale * std::sin(frequency * (t - lag)); }, 0,
                   end);
  }

  // NaN where there is nothing to compare.
  static Estimate of_forced_mode(const TimeSeries& candidate, Estimate ModeComparison::*metric) {
    try {
      return compare(candidate, wave(), {0, 20}, {{"forced", frequency, false}}).modes[0].*metric;
    } catch (const ComparisonError&) {
      return {nan, nan};
    }
  }

  static ThreeWayVerdict amplitude_verdict(const TimeSeries& candidate) {
    const Estimate error = of_forced_mode(candidate, &ModeComparison::amplitude_error);
    return judge_error(error.value, {0.01, error.half_width}, within_5_percent).verdict;
  }

  static ThreeWayVerdict lag_verdict(const TimeSeries& candidate) {
    const Estimate lag = of_forced_mode(candidate, &ModeComparison::phase_lag_periods);
    return judge_error(lag.value, {0.005, lag.half_width}, {-0.02, 0.02}).verdict;
  }
};

TEST_F(VerdictOnSeries, PassesATrueCandidate) {
  EXPECT_EQ(amplitude_verdict(wave()), ThreeWayVerdict::pass);
  EXPECT_EQ(lag_verdict(wave()), ThreeWayVerdict::pass);
}

TEST_F(VerdictOnSeries, FailsAScaledOneAndIsInconclusiveNearTheLimit) {
  EXPECT_EQ(amplitude_verdict(wave(1.07)), ThreeWayVerdict::fail);
  EXPECT_EQ(amplitude_verdict(wave(0.93)), ThreeWayVerdict::fail);
  EXPECT_EQ(amplitude_verdict(wave(1.045)), ThreeWayVerdict::inconclusive);
}

TEST_F(VerdictOnSeries, FailsAShiftedOne) {
  const double period = two_pi / frequency;
  EXPECT_EQ(lag_verdict(wave(1, 0.03 * period)), ThreeWayVerdict::fail);
  EXPECT_EQ(lag_verdict(wave(1, -0.03 * period)), ThreeWayVerdict::fail);
}

TEST_F(VerdictOnSeries, FailsATruncatedOneAndOneWithNaN) {
  TimeSeries poisoned = wave();
  poisoned.value[1000] = nan;
  for (const TimeSeries& candidate : {poisoned, wave(1, 0, 15)}) {
    EXPECT_EQ(amplitude_verdict(candidate), ThreeWayVerdict::fail);
    EXPECT_EQ(lag_verdict(candidate), ThreeWayVerdict::fail);
  }
}

}  // namespace
}  // namespace slosh::three_way_verdict_test
