// The figures of two samples of peaks: what they are defined as.
#include "verification/gate/distributions/peak_comparison.hpp"

#include <gtest/gtest.h>

namespace slosh::peak_comparison_test {
namespace {

Distribution spread(std::size_t count, double scale = 1) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(scale * (0.5 + static_cast<double>(i) / static_cast<double>(count - 1)));
  return {"peaks", std::move(values)};
}

TEST(PeakComparison, IsWhatItIsDefinedAsAndSeesNoDifferenceOfASampleWithItself) {
  const PeakComparison found = compare_peaks(spread(41, 1.3), spread(41)),
                       same = compare_peaks(spread(41), spread(41));
  EXPECT_NEAR(found.median_error.value.value, 0.3, 1e-12);
  EXPECT_LT(found.mean_p.value, 0.01);
  EXPECT_LT(found.ks_p.value, 0.02);
  EXPECT_LT(found.ad_p.value, 0.01);
  const auto& [value, interval] = found.median_error;
  EXPECT_LT(interval.low, value.value);
  EXPECT_GT(interval.high, value.value);
  EXPECT_GT(interval.low, 0);
  for (const double p : {same.mean_p.value, same.ks_p.value, same.ad_p.value}) EXPECT_EQ(p, 1);
  EXPECT_EQ(same.median_error.value.value, 0);
}

TEST(PeakComparison, TakesEachMetricAsOneOfItsFigures) {
  const Distribution one = spread(30, 1.1), other = spread(40);
  const PeakComparison all = compare_peaks(one, other);
  const auto value = [&](Metric metric) { return peak_metric(metric, one, other).value; };
  EXPECT_EQ(value(Metric::peak_mean_p_value), all.mean_p.value);
  EXPECT_EQ(value(Metric::peak_ks_p_value), all.ks_p.value);
  EXPECT_EQ(value(Metric::peak_ad_p_value), all.ad_p.value);
  EXPECT_EQ(value(Metric::peak_median_error), all.median_error.value.value);
  EXPECT_THROW(value(Metric::impact_arrival), std::logic_error);
}

TEST(PeakComparison, OfFewerThanTwentyPeaksIsRefused) {
  EXPECT_THROW(compare_peaks(spread(19), spread(40)), ComparisonError);
  EXPECT_THROW(compare_peaks(spread(40), spread(19)), ComparisonError);
  EXPECT_THROW(compare_peaks(spread(40), spread(40, -1)), ComparisonError);
  EXPECT_NO_THROW(compare_peaks(spread(20), spread(20)));
}

}  // namespace
}  // namespace slosh::peak_comparison_test
