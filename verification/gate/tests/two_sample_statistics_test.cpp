// The statistics of two samples against published and independently computed values.
#include "verification/gate/distributions/two_sample_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slosh::two_sample_statistics_test {
namespace {

Distribution of(std::vector<double> values) { return {"peaks", std::move(values)}; }

// The smoothness of paper by four laboratories (Scholz & Stephens 1987, section 7).
const std::vector<Distribution> laboratories{of({38.7, 41.5, 43.8, 44.5, 45.5, 46.0, 47.7, 58.0}),
                                             of({39.2, 39.3, 39.7, 41.4, 41.8, 42.9, 43.3, 45.8}),
                                             of({34.0, 35.0, 39.0, 40.0, 43.0, 43.0, 44.0, 45.0}),
                                             of({34.0, 34.8, 34.8, 35.4, 37.2, 37.8, 41.2, 42.8})};

double of_two(double (PooledSamples::*statistic)(const std::vector<int>&) const,
              const Distribution& one, const Distribution& other) {
  const PooledSamples pooled({one, other});
  return (pooled.*statistic)(pooled.counts_of(one));
}

double anderson_darling(const Distribution& one, const Distribution& other) {
  return of_two(&PooledSamples::anderson_darling, one, other);
}

double kolmogorov_smirnov(const Distribution& one, const Distribution& other) {
  return of_two(&PooledSamples::kolmogorov_smirnov, one, other);
}

TEST(TwoSampleStatistics, AndersonAndDarlingsOfFourSamplesIsThePublishedOne) {
  EXPECT_NEAR(PooledSamples(laboratories).anderson_darling(laboratories), 8.3926, 5e-5);
}

// By the sums of equation 7 written out in another language, counting anew for each value.
TEST(TwoSampleStatistics, AndersonAndDarlingsOfTwoSamplesWithTiesIsTheSumWrittenOut) {
  EXPECT_NEAR(anderson_darling(laboratories[2], laboratories[3]), 1.8064547195377678, 1e-12);
  EXPECT_NEAR(anderson_darling(laboratories[0], laboratories[3]), 5.1754222641328615, 1e-12);
  for (const auto& [one, other] : {std::pair{2, 3}, {0, 1}, {0, 3}}) {
    const Distribution &a = laboratories.at(static_cast<std::size_t>(one)),
                       &b = laboratories.at(static_cast<std::size_t>(other));
    EXPECT_NEAR(PooledSamples({a, b}).anderson_darling(std::vector{a, b}), anderson_darling(a, b),
                1e-12);
    EXPECT_NEAR(anderson_darling(b, a), anderson_darling(a, b), 1e-12);
  }
}

TEST(TwoSampleStatistics, KolmogorovAndSmirnovsIsTheLargestDistanceOfTheSteps) {
  EXPECT_EQ(kolmogorov_smirnov(of({1, 2}), of({3, 4, 5})), 1);
  EXPECT_EQ(kolmogorov_smirnov(of({1, 2, 3}), of({1, 2, 3})), 0);
  // At 35.4 three of eight laboratories' values against two of eight differ less than at 37.8,
  // where it is 2/8 against 6/8.
  EXPECT_EQ(kolmogorov_smirnov(laboratories[2], laboratories[3]), 0.5);
  // F_1 = 1/2 from 1 on, F_2 = 3/4 from 2 on: the ties at 2 step together.
  EXPECT_EQ(kolmogorov_smirnov(of({1, 2}), of({2, 2, 2, 5})), 0.5);
}

TEST(TwoSampleStatistics, OfValuesThatAreAllEqualAreZero) {
  const Distribution one = of({5, 5}), other = of({5, 5, 5});
  EXPECT_EQ(kolmogorov_smirnov(one, other), 0);
  EXPECT_EQ(anderson_darling(one, other), 0);
  EXPECT_EQ(welch_p_value(one, other), 1);
  EXPECT_EQ(welch_p_value(one, of({6, 6})), 0);
}

// The quantiles of 97.5 % in the table of Student's distribution are 2.228139 of 10 degrees of
// freedom and 4.302653 of 2.
TEST(TwoSampleStatistics, WelchsPValueIsThatOfTheTables) {
  const std::vector<double> values{1, 2, 3, 4, 5, 6};
  const double deviation = std::sqrt(3.5), shift = 2.228139 * deviation * std::sqrt(2.0 / 6);
  std::vector<double> shifted = values;
  for (double& value : shifted) value += shift;
  EXPECT_NEAR(welch_p_value(of(values), of(shifted)), 0.05, 1e-7);
  // A sample that does not scatter leaves the other's freedom alone.
  const double mean = 4.302653 / std::sqrt(3.0);
  EXPECT_NEAR(welch_p_value(of({-1, 0, 1}), of({mean, mean, mean, mean})), 0.05, 1e-7);
  EXPECT_THROW(welch_p_value(of({1}), of({1, 2})), ComparisonError);
}

}  // namespace
}  // namespace slosh::two_sample_statistics_test
