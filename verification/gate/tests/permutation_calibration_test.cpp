// The p-values by permutation, calibrated on samples of one known distribution.
#include <gtest/gtest.h>

#include "verification/gate/distributions/permutation_test.hpp"
#include "verification/gate/tests/random_peaks.hpp"

namespace slosh::permutation_calibration_test {
namespace {

struct Rejected {
  double mean = 0, ks = 0, ad = 0;  // the shares of trials with p < 5 %
};

Rejected rejected(double scale, int trials) {
  RandomPeaks random(20);
  Rejected share;
  const auto add = [&](double& one, double p) { one += (p < 0.05 ? 1.0 : 0.0) / trials; };
  for (int k = 0; k < trials; ++k) {
    const Distribution candidate = random.sample(of_candidate, scale),
                       experiment = random.sample(of_experiment);
    const SeededTrials divisions{399, static_cast<std::uint64_t>(k)};
    const auto p = [&](const TwoSampleStatistic& statistic) {
      return permutation_p_value(candidate, experiment, statistic, divisions).value;
    };
    add(share.mean, welch_p_value(candidate, experiment));
    add(share.ks, p(kolmogorov_smirnov_statistic));
    add(share.ad, p(anderson_darling_statistic));
  }
  return share;
}

TEST(PermutationTest, RejectsOneDistributionInFivePercentOfAllCases) {
  constexpr int trials = 3000;
  const Rejected share = rejected(1, trials);
  const double half_width = binomial_half_width(0.05, trials);
  EXPECT_NEAR(share.mean, 0.05, half_width);
  EXPECT_NEAR(share.ks, 0.05, half_width);
  EXPECT_NEAR(share.ad, 0.05, half_width);
}

TEST(PermutationTest, SeesPeaksThatAreAQuarterTooHighInMostCases) {
  constexpr int trials = 1000;
  const Rejected share = rejected(1.25, trials);
  EXPECT_NEAR(share.mean, 0.80, 0.045);
  EXPECT_NEAR(share.ks, 0.74, 0.045);
  EXPECT_NEAR(share.ad, 0.83, 0.045);
}

}  // namespace
}  // namespace slosh::permutation_calibration_test
