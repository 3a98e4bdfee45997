#include "verification/metrics/time_alignment.hpp"

#include <gtest/gtest.h>

#include <cmath>

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

TEST(TimeAlignment, FindsTheLagOfACandidateThatIsLate) {
  const TimeAlignment late = align_in_time(run_away(0.537, 1, 0.01), run_away(0.3, 1, 0.2));
  EXPECT_NEAR(late.lag, 0.237, 1e-3);
  EXPECT_LT(late.normalised_rms, 1e-3);
}

TEST(TimeAlignment, HasANegativeLagForACandidateThatLeads) {
  EXPECT_NEAR(align_in_time(run_away(0.1, 1, 0.01), run_away(0.3, 1, 0.2)).lag, -0.2, 1e-3);
}

TEST(TimeAlignment, LeavesAnErrorOfSpeedAsItIs) {
  const TimeAlignment fast = align_in_time(run_away(0.1, 1.2, 0.01), run_away(0.3, 1, 0.2));
  EXPECT_GT(fast.normalised_rms, 0.03);
}

TEST(TimeAlignment, HasNoNumbersWhereTheBestLagIsOutOfItsRange) {
  const TimeAlignment far = align_in_time(run_away(2.0, 1, 0.01), run_away(0.3, 1, 0.2));
  EXPECT_TRUE(std::isnan(far.lag));
  EXPECT_TRUE(std::isnan(far.normalised_rms));
}

}  // namespace
}  // namespace slosh::time_alignment_test
