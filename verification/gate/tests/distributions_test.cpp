// The statistics of two samples of peaks against published and independently computed values, and
// their intervals and p-values against known truth.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

#include "verification/gate/distributions/bootstrap_interval.hpp"
#include "verification/gate/distributions/holm_correction.hpp"
#include "verification/gate/distributions/median_interval.hpp"
#include "verification/gate/distributions/peak_comparison.hpp"
#include "verification/gate/distributions/permutation_test.hpp"
#include "verification/gate/distributions/two_sample_statistics.hpp"
#include "verification/gate/tests/random_peaks.hpp"

namespace slosh::distributions_test {
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

TEST(SeededDraws, AreThoseOfTheStandardsGenerator) {
  // The first number of std::mt19937_64 with the seed 5489 is 14514284786278117030 ([rand.predef]
  // fixes the 10000th); 2^64 modulo 1000 is 616, so that it is not drawn again.
  SeededDraws draws(5489);
  EXPECT_EQ(draws.below(1000), 30u);
  std::array<int, 3> count{};
  for (int k = 0; k < 30000; ++k) ++count.at(draws.below(3));
  for (const int of_one : count) EXPECT_NEAR(of_one, 10000, 270);  // 3.29 deviations of 82
  EXPECT_EQ(draws.below(1), 0u);
}

// Of the 20 divisions of six values into three and three, two have the distance 1.
TEST(PermutationTest, IsTheShareOfAllDivisionsWhereTheyAreFew) {
  const Estimate p =
      permutation_p_value(of({1, 2, 3}), of({4, 5, 6}), kolmogorov_smirnov_statistic, {100000, 1});
  EXPECT_NEAR(p.value, 0.1, p.half_width);
  EXPECT_NEAR(p.half_width, 1.96 * std::sqrt(0.1 * 0.9 / 100000), 2e-5);
  EXPECT_EQ(permutation_p_value(of({1, 1}), of({1, 1}), anderson_darling_statistic).value, 1);
}

TEST(PermutationTest, HasOnePValueOfTwoSamplesEverywhere) {
  const Distribution one = of({2, 5, 7, 8, 9, 11, 13, 20}), other = of({1, 3, 4, 5, 6, 8, 10});
  const Estimate p = permutation_p_value(one, other, kolmogorov_smirnov_statistic);
  EXPECT_EQ(p.value, permutation_p_value(one, other, kolmogorov_smirnov_statistic).value);
  EXPECT_EQ(std::lround(p.value * (permutations.count + 1)), 2947);
}

TEST(PermutationTest, IsNeverZeroAndSaysHowWellItIsKnown) {
  std::vector<double> low, high;
  for (int i = 0; i < 30; ++i) {
    low.push_back(i);
    high.push_back(100 + i);
  }
  const Estimate p = permutation_p_value(of(low), of(high), anderson_darling_statistic);
  EXPECT_DOUBLE_EQ(p.value, 1.0 / (permutations.count + 1));
  EXPECT_GT(p.half_width, 1e-4);
  EXPECT_LT(p.half_width, 5e-4);
}

TEST(HolmCorrection, IsWhatItIsDefinedAs) {
  // Holm's step-down by hand: 4 x 0.01, 3 x 0.02, then 2 x 0.03 which is no smaller, then 0.2.
  const std::vector<Estimate> family{{0.2, 0.02}, {0.01, 0.001}, {0.03, 0.003}, {0.02, 0.002}};
  const double expected[] = {0.2, 0.04, 0.06, 0.06};
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(holm_corrected(family, i).value, expected[i], 1e-15) << i;
  EXPECT_NEAR(holm_corrected(family, 1).half_width, 0.004, 1e-15);
  EXPECT_EQ(holm_corrected({{0.9, 0}, {0.8, 0}}, 0).value, 1);
  EXPECT_EQ(holm_corrected({{0.03, 0.004}}, 0).value, 0.03);
}

TEST(HolmCorrection, CountsAnImpactThatDoesNotOccurAsRejected) {
  EXPECT_EQ(holm_corrected({{not_a_number, 0}, {0.03, 0}}, 0).value, 0);
  EXPECT_NEAR(holm_corrected({{not_a_number, 0}, {0.03, 0}}, 1).value, 0.03, 1e-15);
}

GateRow row_of(const char* candidate, Metric metric, const char* mode, const char* quantity) {
  GateRow row{};
  row.candidate = candidate;
  row.metric = metric;
  row.mode = mode;
  row.quantity = quantity;
  return row;
}

TEST(HolmCorrection, HasTheRowsOfOneCandidateAndPressureAsAFamily) {
  const GateRow own = row_of("a", Metric::peak_ks_p_value, "impact_1", "p");
  const std::vector<GateRow> rows{own,
                                  row_of("a", Metric::peak_ad_p_value, "impact_1", "p"),
                                  row_of("a", Metric::peak_ks_p_value, "impact_2", "p"),
                                  row_of("a", Metric::peak_median_error, "impact_2", "p"),
                                  row_of("a", Metric::peak_ks_p_value, "impact_2", "p/filtered"),
                                  row_of("b", Metric::peak_ks_p_value, "impact_1", "p")};
  const std::vector<GateRow> rest = rest_of_family(own, rows);
  ASSERT_EQ(rest.size(), 2U);
  EXPECT_EQ(rest[0].metric, Metric::peak_ad_p_value);
  EXPECT_EQ(rest[1].mode, "impact_2");
  EXPECT_TRUE(rest_of_family(own, {}).empty());
}

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
        bootstrap_interval(candidate, experiment, figure, {399, static_cast<std::uint64_t>(k)});
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

struct Known {
  const char* name;
  double median;
  std::function<double(double normal, double uniform)> value;
};

const std::vector<Known> distributions{
    {"normal", 0, [](double z, double) { return z; }},
    {"lognormal", 1, [](double z, double) { return std::exp(0.5 * z); }},
    {"uniform", 0.5, [](double, double u) { return u; }},
    {"Laplace", 0, [](double z, double u) { return std::copysign(std::log(u), z); }},
    // Of the mixture 0.85 Phi(x) + 0.15 the median is where Phi(x) = 0.35 / 0.85.
    {"one in seven early", -0.22301, [](double z, double u) { return u < 0.15 ? z - 20 : z; }}};

double held(const Known& known, std::size_t n, int trials) {
  RandomPeaks normals(11);
  SeededDraws uniforms(12);
  int count = 0;
  for (int k = 0; k < trials; ++k) {
    std::vector<double> values(n);
    for (double& value : values)
      value = known.value(std::log(normals.sample(1).sorted().front()) / 0.3,
                          (static_cast<double>(uniforms.below(1'000'000)) + 0.5) * 1e-6);
    const Interval interval = median_interval({"values", values});
    count += interval.low <= known.median && known.median <= interval.high;
  }
  return static_cast<double>(count) / trials;
}

TEST(MedianInterval, HoldsTheTrueMedianInNineteenOfTwentySamples) {
  constexpr int trials = 4000;
  for (const Known& known : distributions)
    for (const std::size_t n : {std::size_t{3}, std::size_t{4}, std::size_t{8}, std::size_t{20}}) {
      const double share = held(known, n, trials), least = n < 6 ? 0.92 : 0.945;
      EXPECT_GE(share, least - binomial_half_width(least, trials)) << known.name << " " << n;
      EXPECT_LE(share, 0.97 + binomial_half_width(0.97, trials)) << known.name << " " << n;
    }
}

TEST(MedianInterval, LiesBetweenTheExtremesOfSixValuesOrMoreWhateverOneOfThemIs) {
  std::vector<double> values{-30, -31, -29, -28, -33, -27, -32, -270};
  const Interval interval = median_interval({"arrivals", values});
  EXPECT_GE(interval.low, -270);
  EXPECT_LE(interval.high, -27);
  values.assign({-30, -31, -29, -28, -33, -27, -32, -26, -34, -270});
  EXPECT_GT(median_interval({"arrivals", values}).low, -35);
}

TEST(MedianInterval, OfTwoNormalValuesIsStudentsInterval) {
  // t_(0.975, 1) s / sqrt(2), s = range / sqrt(2)
  const Interval interval = median_interval({"two", {1, 3}});
  EXPECT_NEAR(interval.high - 2, 12.7062, 1e-3);
  EXPECT_NEAR(2 - interval.low, 12.7062, 1e-3);
  EXPECT_TRUE(std::isnan(median_interval({"one", {1}}).low));
}

// The exact values of n = 8: g_1 = 1 - 2/256, g_2 = 1 - 18/256.
TEST(MedianInterval, OfEightValuesIsBetweenTheFirstTwoAndTheLastTwo) {
  const Interval interval = median_interval({"eight", {1, 2, 3, 4, 5, 6, 7, 8}});
  const double part = (1 - 2 / 256.0 - 0.95) * 16, inwards = 7 * part / (1 + 6 * part);
  EXPECT_NEAR(interval.low, 1 + inwards, 1e-12);
  EXPECT_NEAR(interval.high, 8 - inwards, 1e-12);
}

}  // namespace
}  // namespace slosh::distributions_test
