#include "verification/metrics/ensemble_mean.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>

namespace slosh::ensemble_mean_test {
namespace {

using Values = std::vector<std::vector<double>>;

std::vector<std::vector<Estimate>> pairs_of(const Values& values, double half_width = 0) {
  std::vector<std::vector<Estimate>> pairs;
  for (const std::vector<double>& row : values) {
    pairs.emplace_back();
    for (const double value : row) pairs.back().push_back({value, half_width});
  }
  return pairs;
}

TEST(EnsembleMean, IsTheMeanOfAllPairsWithStudentsInterval) {
  // 1, 2, 6 against one exact reference: s^2 = 7, t_(0.975, 2) = 4.3027.
  const Estimate found = ensemble_mean(pairs_of({{1}, {2}, {6}}), SingleSide::exact);
  EXPECT_DOUBLE_EQ(found.value, 3);
  EXPECT_NEAR(found.half_width, 4.30265 * std::sqrt(7.0 / 3), 1e-4);
  // Against one run of many the other side's scatter counts once more.
  EXPECT_NEAR(ensemble_mean(pairs_of({{1}, {2}, {6}}), SingleSide::one_of_many).half_width,
              4.30265 * std::sqrt(7 * (1 + 1.0 / 3)), 1e-4);
  EXPECT_NEAR(ensemble_mean(pairs_of({{1, 2, 6}}), SingleSide::exact).half_width, found.half_width,
              1e-12);
}

TEST(EnsembleMean, OfCopiesHasTheirOwnInterval) {
  const Values alike{{2}, {2}, {2}}, nearly{{2}, {2 + 1e-6}, {2 - 1e-6}};
  EXPECT_EQ(ensemble_mean(pairs_of(alike), SingleSide::exact).half_width, 0);
  for (const Values& values : {alike, nearly, Values{{2, 2}, {2, 2}}})
    for (const SingleSide single : {SingleSide::exact, SingleSide::one_of_many})
      EXPECT_NEAR(ensemble_mean(pairs_of(values, 0.7), single).half_width, 0.7, 1e-9);
}

TEST(EnsembleMean, OfRunsThatScatterHasNoneOfTheirOwn) {
  const Values apart{{1}, {2}, {3}};
  EXPECT_EQ(ensemble_mean(pairs_of(apart, 0.7), SingleSide::exact).half_width,
            ensemble_mean(pairs_of(apart), SingleSide::exact).half_width);
  Values many;
  for (int i = 0; i < 200; ++i) many.push_back({2 + 0.3 * std::sin(7.0 * i)});
  EXPECT_LT(ensemble_mean(pairs_of(many, 0.7), SingleSide::exact).half_width, 0.04)
      << "their mean is known to less than a tenth of the interval of one";
}

TEST(EnsembleMean, AddsTheSpreadOfBothSidesAfterWelch) {
  // m_ij = x_i - y_j, x = 1, 2, 6 (variance 7), y = 0, 2 (variance 2).
  const Estimate found = ensemble_mean(pairs_of({{1, -1}, {2, 0}, {6, 4}}), SingleSide::exact);
  EXPECT_DOUBLE_EQ(found.value, 2);
  const double a = 7.0 / 3, b = 1, freedom = (a + b) * (a + b) / (a * a / 2 + b * b);
  EXPECT_NEAR(freedom, 2.985, 1e-3);
  EXPECT_NEAR(found.half_width, 3.190 * std::sqrt(a + b), 5e-3);  // t_(0.975, 2.985)
}

// Runs whose amplitudes are off by e, normal about a bias: the magnitude |e| has a known mean. Two
// runs at +15 and -15 % have |e| = 15.00 +- 0.07 % without the spread of their series.
TEST(EnsembleMean, OfAMagnitudeHoldsTheTruthBySpreadOfTheSeries) {
  EXPECT_NEAR(ensemble_mean(pairs_of({{0.15}, {0.1501}}), SingleSide::exact).half_width, 0.0006,
              1e-4);
  EXPECT_GT(ensemble_mean(pairs_of({{0.15}, {0.1501}}), SingleSide::exact, {0.2122, 0}).half_width,
            1.8);
  std::mt19937 generator(7);
  std::normal_distribution<double> normal;
  constexpr int ensembles = 4000;
  for (const double bias : {0.0, 0.5, 3.0})
    for (const int members : {2, 3, 8}) {
      const double truth = std::sqrt(2 / std::numbers::pi) * std::exp(-bias * bias / 2) +
                           bias * std::erf(bias / std::sqrt(2.0));
      int held = 0;
      for (int trial = 0; trial < ensembles; ++trial) {
        Values magnitudes;
        double sum = 0, squares = 0;
        for (int i = 0; i < members; ++i) {
          const double error = bias + normal(generator);
          magnitudes.push_back({std::abs(error)});
          sum += error;
          squares += error * error;
        }
        const double deviation = std::sqrt((squares - sum * sum / members) / (members - 1));
        const Estimate found =
            ensemble_mean(pairs_of(magnitudes), SingleSide::exact, {deviation, 0});
        held += std::abs(found.value - truth) <= found.half_width;
      }
      EXPECT_GT(held, 0.94 * ensembles) << bias << " of " << members;
    }
}

TEST(EnsembleMean, IsNoNumberWhereAMemberIsNoneAndRefusesASinglePair) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Estimate found = ensemble_mean(pairs_of({{1}, {nan}, {2}}), SingleSide::exact);
  EXPECT_TRUE(std::isnan(found.value));
  EXPECT_TRUE(std::isnan(found.half_width));
  EXPECT_THROW(ensemble_mean(pairs_of({{2}}), SingleSide::exact), std::invalid_argument);
  EXPECT_THROW(ensemble_mean(pairs_of({}), SingleSide::exact), std::invalid_argument);
}

struct Scenario {
  std::string name;
  std::size_t candidates, references;
  double candidate_deviation, reference_deviation;
  SingleSide single;
};

class EnsembleCoverage : public ::testing::TestWithParam<Scenario> {};

// The ratios of two amplitudes that scatter by a few percent, less 1; the truth is -0.05.
TEST_P(EnsembleCoverage, OfTheIntervalIs95Percent) {
  const Scenario& of = GetParam();
  std::mt19937_64 generator(14);
  std::normal_distribution<double> normal;
  constexpr int draws = 2000;
  int covered = 0;
  for (int draw = 0; draw < draws; ++draw) {
    std::vector<double> candidate, reference;
    for (std::size_t i = 0; i < of.candidates; ++i)
      candidate.push_back(0.95 + of.candidate_deviation * normal(generator));
    for (std::size_t j = 0; j < of.references; ++j)
      reference.push_back(1 + of.reference_deviation * normal(generator));
    std::vector<std::vector<double>> values;
    for (const double c : candidate) {
      values.emplace_back();
      for (const double r : reference) values.back().push_back(c / r - 1);
    }
    const Estimate found = ensemble_mean(pairs_of(values), of.single);
    covered += std::abs(found.value + 0.05) <= found.half_width;
  }
  EXPECT_GE(covered, 0.91 * draws);
  EXPECT_LE(covered, 0.99 * draws);
}

TEST(MeanOfMembers, HasTheIntervalOfStudentsDistribution) {
  const Estimate found = mean_of_members({1, 2, 3, 4});
  EXPECT_EQ(found.value, 2.5);
  EXPECT_NEAR(found.half_width, 3.182446 * std::sqrt(5.0 / 3 / 4), 1e-6);
  EXPECT_EQ(mean_of_members({7}).half_width, 0);
  EXPECT_TRUE(std::isnan(mean_of_members({1, not_a_number}).value));
  EXPECT_THROW(mean_of_members({}), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(
    Scenarios, EnsembleCoverage,
    ::testing::Values(Scenario{"FourAgainstFour", 4, 4, 0.03, 0.03, SingleSide::exact},
                      Scenario{"FourAgainstTwo", 4, 2, 0.03, 0.01, SingleSide::exact},
                      Scenario{"ThreeAgainstThreeUnequal", 3, 3, 0.05, 0.01, SingleSide::exact},
                      Scenario{"EightAgainstFour", 8, 4, 0.02, 0.04, SingleSide::exact},
                      Scenario{"ThreeAgainstTheory", 3, 1, 0.03, 0, SingleSide::exact},
                      Scenario{"FiveAgainstOneRun", 5, 1, 0.03, 0.03, SingleSide::one_of_many},
                      Scenario{"OneRunAgainstFour", 1, 4, 0.03, 0.03, SingleSide::one_of_many}),
    [](const auto& scenario) { return scenario.param.name; });

}  // namespace
}  // namespace slosh::ensemble_mean_test
