#include "verification/metrics/time_alignment.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "verification/tests/synthetic_series.hpp"

namespace slosh::time_alignment_test {
namespace {

// The place of a body that starts at `begin`, accelerates for a second and then runs on.
TimeSeries run_away(double begin, double speed, double interval) {
  TimeSeries series{"front_position", "m", {}, {}};
  for (double t = 0; t < 4; t += interval) {
    const double since = std::max(0.0, t - begin);
    series.time.push_back(t);
    series.value.push_back(1 + speed * (since < 1 ? 0.5 * since * since : since - 0.5));
  }
  return series;
}

TEST(TimeAlignment, FindsTheLagOfACandidateThatIsLateOrLeadsAndNoNumberOutOfItsRange) {
  const auto aligned = [](double begin, double speed) {
    return align_in_time(run_away(begin, speed, 0.01), run_away(0.3, 1, 0.2));
  };
  EXPECT_NEAR(aligned(0.537, 1).lag, 0.237, 1e-3);
  EXPECT_LT(aligned(0.537, 1).normalised_rms, 1e-3);
  EXPECT_NEAR(aligned(0.1, 1).lag, -0.2, 1e-3);
  EXPECT_GT(aligned(0.1, 1.2).normalised_rms, 0.03) << "an error of speed is left";
  EXPECT_TRUE(std::isnan(aligned(2, 1).lag));
  EXPECT_TRUE(std::isnan(aligned(2, 1).normalised_rms));
}

TimeSeries periodic(double lag, double interval = 0.01, double end = 8) {
  return sampled(
      [lag](double t) {
        return 3 + std::sin(two_pi * (t - lag)) + 0.3 * std::cos(2 * two_pi * (t - lag));
      },
      0, end, interval);
}

TEST(TimeAlignment, HasNoLagForEqualSeries) {
  for (const double end : {8.0, 7.3, 4.0})
    for (const double interval : {0.01, 0.1}) {
      const auto same = periodic(0, interval, end);
      EXPECT_EQ(align_in_time(same, same).lag, 0) << end;
      EXPECT_EQ(align_in_time(same, same).normalised_rms, 0) << end;
    }
  EXPECT_EQ(align_in_time(run_away(0.3, 1, 0.2), run_away(0.3, 1, 0.2)).lag, 0);
}

// A surface above the bottom against one above the still level.
TEST(TimeAlignment, HasNoNumbersForSeriesOfDifferentDataOrUnits) {
  for (const double datum : {30.0, -10.0, 2.0}) {
    auto other = periodic(0.05);
    for (double& value : other.value) value += datum;
    EXPECT_TRUE(std::isnan(align_in_time(other, periodic(0)).lag)) << datum;
  }
  auto other = periodic(0.05);
  for (double& value : other.value) value += 0.3;
  EXPECT_NEAR(align_in_time(other, periodic(0)).lag, 0.05, 2e-3);
}

TEST(TimeAlignment, TakesTheLagNearestToZeroOfAPeriodicSignal) {
  for (const double lag : {0.05, -0.05, 0.237, -0.4})
    for (const double interval : {0.01, 0.1}) {
      const TimeAlignment found = align_in_time(periodic(lag), periodic(0, interval));
      EXPECT_NEAR(found.lag, lag, 2e-3) << interval;
      EXPECT_LT(found.normalised_rms, 0.03);
    }
  const auto noisy = [](double lag, std::uint64_t seed) {
    return with_noise(periodic(lag), 0.1, 0.5, seed);
  };
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    EXPECT_NEAR(align_in_time(noisy(0.05, seed), noisy(0, seed + 100)).lag, 0.05, 0.02) << seed;
}

TEST(TimeAlignment, LeavesWhatIsScaledOrShiftedInTheError) {
  auto wrong = periodic(0.05);
  for (double& value : wrong.value) value *= 1.2;
  EXPECT_GT(align_in_time(wrong, periodic(0)).normalised_rms, 0.15);
  wrong = periodic(0.05);
  for (double& value : wrong.value) value += 1;
  const TimeAlignment raised = align_in_time(wrong, periodic(0));
  EXPECT_NEAR(raised.lag, 0.05, 0.01);
  EXPECT_GT(raised.normalised_rms, 1);
}

}  // namespace
}  // namespace slosh::time_alignment_test
