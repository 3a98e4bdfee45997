// P-values by permutation, and families of them, calibrated on samples of one known distribution: a
// perfect model passes them, a wrong one does not.
#include <gtest/gtest.h>

#include "verification/gate/distributions/holm_correction.hpp"
#include "verification/gate/distributions/permutation_test.hpp"
#include "verification/gate/tests/random_peaks.hpp"

namespace slosh::p_value_calibration_test {
namespace {

struct Shares {
  double mean = 0, ks = 0, ad = 0;  // the shares of trials with p < 5 %
};

Shares shares(double scale, int trials) {
  RandomPeaks random(20);
  Shares share;
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
  const Shares share = shares(1, trials);
  const double half_width = binomial_half_width(0.05, trials);
  EXPECT_NEAR(share.mean, 0.05, half_width);
  EXPECT_NEAR(share.ks, 0.05, half_width);
  EXPECT_NEAR(share.ad, 0.05, half_width);
}

TEST(PermutationTest, SeesPeaksThatAreAQuarterTooHighInMostCases) {
  constexpr int trials = 1000;
  const Shares share = shares(1.25, trials);
  EXPECT_NEAR(share.mean, 0.80, 0.045);
  EXPECT_NEAR(share.ks, 0.74, 0.045);
  EXPECT_NEAR(share.ad, 0.83, 0.045);
}

// The twelve p-values of spheric10_water: three tests of each of four impacts.
std::vector<Estimate> family_of(RandomPeaks& random, double scale) {
  constexpr SeededTrials few{999, 1987};
  std::vector<Estimate> family;
  for (int impact = 0; impact < 4; ++impact) {
    const Distribution candidate = random.sample(of_candidate, scale),
                       experiment = random.sample(of_experiment);
    family.push_back({welch_p_value(candidate, experiment), 0});
    family.push_back(permutation_p_value(candidate, experiment, kolmogorov_smirnov_statistic, few));
    family.push_back(permutation_p_value(candidate, experiment, anderson_darling_statistic, few));
  }
  return family;
}

struct Rejected {
  int raw = 0, corrected = 0;  // families of which one p-value or more is below 5 %
};

Rejected rejected(double scale, int trials) {
  RandomPeaks random(31);
  Rejected count;
  for (int k = 0; k < trials; ++k) {
    const std::vector<Estimate> family = family_of(random, scale);
    bool raw = false, corrected = false;
    for (std::size_t i = 0; i < family.size(); ++i) {
      raw |= family[i].value < 0.05;
      corrected |= holm_corrected(family, i).value < 0.05;
    }
    count.raw += raw;
    count.corrected += corrected;
  }
  return count;
}

TEST(HolmCorrection, LetsAPerfectModelFailAFamilyInFivePercentAtMost) {
  constexpr int trials = 300;
  const Rejected count = rejected(1, trials);
  EXPECT_GT(count.raw, 0.15 * trials);
  EXPECT_LE(count.corrected, (0.05 + binomial_half_width(0.05, trials)) * trials);
}

TEST(HolmCorrection, FindsAModelWhosePeaksAreHalfAsHighAgain) {
  for (const double scale : {1.5, 1 / 1.5}) EXPECT_EQ(rejected(scale, 60).corrected, 60) << scale;
}

}  // namespace
}  // namespace slosh::p_value_calibration_test
