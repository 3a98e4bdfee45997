// The p-values by permutation: exact where all divisions can be counted.
#include "verification/gate/distributions/permutation_test.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace slosh::permutation_test_test {
namespace {

Distribution of(std::vector<double> values) { return {"peaks", std::move(values)}; }

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

}  // namespace
}  // namespace slosh::permutation_test_test
