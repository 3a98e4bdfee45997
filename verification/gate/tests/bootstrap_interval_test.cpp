// The bootstrap's intervals against known truth.
#include "verification/gate/distributions/bootstrap_interval.hpp"

#include <gtest/gtest.h>

#include "verification/gate/tests/random_peaks.hpp"

namespace slosh::bootstrap_interval_test {
namespace {

constexpr double quarter_too_high = 1.25;

double median_ratio(const Distribution& one, const Distribution& other) {
  return one.quantile(0.5) / other.quantile(0.5);
}

struct Held {
  double interval = 0, wider_side = 0;  // the shares of trials that hold the truth
};

constexpr int trials = 600;

Held held(const TwoSampleFigure& figure, double truth) {
  RandomPeaks random(4);
  Held share;
  for (int k = 0; k < trials; ++k) {
    const Distribution candidate = random.sample(of_candidate, quarter_too_high),
                       experiment = random.sample(of_experiment);
    const Interval interval =
        bootstrap_interval(candidate, experiment, figure, {199, static_cast<std::uint64_t>(k)});
    const Estimate value = wider_side(figure(candidate, experiment), interval);
    if (interval.low <= truth && truth <= interval.high) share.interval += 1.0 / trials;
    if (std::abs(value.value - truth) <= value.half_width) share.wider_side += 1.0 / trials;
  }
  return share;
}

// What 1000 pairs of each of three distributions gave stands in the header.
TEST(BootstrapInterval, HoldsTheTruthAtTheRateThatItsHeaderStates) {
  const Held share = held(median_ratio, quarter_too_high);
  EXPECT_NEAR(share.interval, 0.955, binomial_half_width(0.955, trials));
  EXPECT_NEAR(share.wider_side, 0.97, binomial_half_width(0.97, trials));
}

TEST(BootstrapInterval, IsTheSameEachTimeAndCountsItsWiderSideToBothSides) {
  RandomPeaks random(1);
  const Distribution one = random.sample(of_candidate), other = random.sample(of_experiment);
  const Interval interval = bootstrap_interval(one, other, median_ratio);
  EXPECT_EQ(interval.low, bootstrap_interval(one, other, median_ratio).low);
  EXPECT_LT(interval.low, median_ratio(one, other));
  EXPECT_GT(interval.high, median_ratio(one, other));
  EXPECT_EQ(wider_side(1, {0.9, 1.3}).value, 1);
  EXPECT_NEAR(wider_side(1, {0.9, 1.3}).half_width, 0.3, 1e-15);
  EXPECT_NEAR(wider_side(1, {0.5, 1.3}).half_width, 0.5, 1e-15);
}

}  // namespace
}  // namespace slosh::bootstrap_interval_test
