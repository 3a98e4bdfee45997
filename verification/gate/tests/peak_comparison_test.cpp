// The figures of two samples of peaks: what they are defined as, and the area's interval where both
// are of one distribution.
#include "verification/gate/distributions/peak_comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "verification/gate/tests/random_peaks.hpp"

namespace slosh::peak_comparison_test {
namespace {

Distribution spread(std::size_t count, double scale = 1) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(scale * (0.5 + static_cast<double>(i) / static_cast<double>(count - 1)));
  return {"peaks", std::move(values)};
}

TEST(PeakComparison, IsWhatItIsDefinedAs) {
  const PeakComparison found = compare_peaks(spread(41, 1.3), spread(41));
  EXPECT_NEAR(found.median_error.value.value, 0.3, 1e-12);
  EXPECT_NEAR(found.p90_error.value.value, 0.3, 1e-12);
  EXPECT_NEAR(found.area.value.value, 0.3, 1e-12);  // the experiment's mean is 1
  EXPECT_LT(found.mean_p.value, 0.01);
  EXPECT_LT(found.ks_p.value, 0.02);
  EXPECT_LT(found.ad_p.value, 0.01);
  for (const SampleFigure* one : {&found.area, &found.median_error, &found.p90_error}) {
    EXPECT_LT(one->interval.low, one->value.value);
    EXPECT_GT(one->interval.high, one->value.value);
    EXPECT_GT(one->interval.low, 0);
  }
}

TEST(PeakComparison, OfASampleWithItselfSeesNoDifference) {
  const PeakComparison found = compare_peaks(spread(41), spread(41));
  for (const double p : {found.mean_p.value, found.ks_p.value, found.ad_p.value}) EXPECT_EQ(p, 1);
  EXPECT_EQ(found.area.value.value, 0);
  EXPECT_EQ(found.area.interval.low, 0);
}

TEST(PeakComparison, TakesEachMetricAsOneOfItsFigures) {
  const Distribution one = spread(30, 1.1), other = spread(40);
  const PeakComparison all = compare_peaks(one, other);
  const auto value = [&](Metric metric) { return peak_metric(metric, one, other).value; };
  EXPECT_EQ(value(Metric::peak_mean_p_value), all.mean_p.value);
  EXPECT_EQ(value(Metric::peak_ks_p_value), all.ks_p.value);
  EXPECT_EQ(value(Metric::peak_ad_p_value), all.ad_p.value);
  EXPECT_EQ(value(Metric::peak_area), all.area.value.value);
  EXPECT_EQ(value(Metric::peak_median_error), all.median_error.value.value);
  EXPECT_EQ(value(Metric::peak_p90_error), all.p90_error.value.value);
  EXPECT_THROW(value(Metric::impact_arrival), std::logic_error);
}

TEST(PeakComparison, OfFewerThanTwentyPeaksIsRefused) {
  EXPECT_THROW(compare_peaks(spread(19), spread(40)), ComparisonError);
  EXPECT_THROW(compare_peaks(spread(40), spread(19)), ComparisonError);
  EXPECT_THROW(compare_peaks(spread(40), spread(40, -1)), ComparisonError);
  EXPECT_NO_THROW(compare_peaks(spread(20), spread(20)));
}

// The bootstrap alone never holds this zero, as no two samples are equal.
TEST(PeakComparison, TheAreasIntervalHoldsZeroInNineteenOfTwentyPairsOfOneDistribution) {
  RandomPeaks random(7);
  constexpr int trials = 150;
  double held = 0;
  for (int k = 0; k < trials; ++k) {
    const Distribution one = random.sample(of_candidate), other = random.sample(of_experiment);
    const Estimate area = peak_metric(Metric::peak_area, one, other);
    if (area.value <= area.half_width) held += 1.0 / trials;
  }
  EXPECT_NEAR(held, 0.95, binomial_half_width(0.95, trials));
}

}  // namespace
}  // namespace slosh::peak_comparison_test
