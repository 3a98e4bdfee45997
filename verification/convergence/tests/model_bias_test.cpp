#include "verification/convergence/model_bias.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace slosh::model_bias_test {
namespace {

std::vector<PredictedValue> with_ratios(const std::vector<double>& ratios, double deviation = 0) {
  std::vector<PredictedValue> values;
  for (const double ratio : ratios) {
    const double reference = 0.01 * static_cast<double>(values.size() + 1);
    values.push_back({ratio * reference, reference, deviation});
  }
  return values;
}

// ln(M / E) = 0.1, 0.2, 0.3, 0.4, 0.5: mean 0.3, variance (0.04 + 0.01 + 0.01 + 0.04) / 4 = 0.025.
std::vector<double> five_ratios() {
  std::vector<double> ratios;
  for (int i = 1; i <= 5; ++i) ratios.push_back(std::exp(0.1 * i));
  return ratios;
}

TEST(ModelBias, OfFiveComparisonsWithAnExactReferenceIsAsWorkedOutByHand) {
  const auto found = model_bias(with_ratios(five_ratios()));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->count, 5u);
  EXPECT_NEAR(found->relative_deviation, std::sqrt(0.025), 1e-12);
  EXPECT_NEAR(found->bias, std::exp(0.3 + 0.0125), 1e-12);
  EXPECT_EQ(found->reference_deviation, 0);
}

TEST(ModelBias, LeavesTheReferencesOwnScatterToTheReference) {
  const auto found = model_bias(with_ratios(five_ratios(), 0.1));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->reference_deviation, 0.1, 1e-12);
  EXPECT_NEAR(found->relative_deviation, std::sqrt(0.025 - 0.01), 1e-12);
  EXPECT_NEAR(found->bias, std::exp(0.3 + 0.015 / 2 - 0.01 / 2), 1e-12);
}

TEST(ModelBias, ShowsNoModelToBeBetterThanWhatItIsComparedWith) {
  const auto found = model_bias(with_ratios(five_ratios(), 0.5));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->relative_deviation, std::sqrt(0.0125), 1e-12);
  EXPECT_NEAR(found->reference_deviation, found->relative_deviation, 1e-12);
  EXPECT_NEAR(found->bias, std::exp(0.3), 1e-12);
}

TEST(ModelBias, OfAModelThatIsAlwaysRightIsOneWithoutScatter) {
  const auto found = model_bias(with_ratios({1, 1, 1, 1, 1, 1}, 0.02));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->bias, 1);
  EXPECT_EQ(found->relative_deviation, 0);
}

TEST(ModelBias, FindsAgainWhatAManyComparisonsWereMadeWith) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  const double bias = 1.13, of_model = 0.06, of_reference = 0.02;
  std::vector<PredictedValue> values;
  for (int i = 0; i < 20000; ++i)
    values.push_back(
        {bias * (1 + of_model * normal(random)), 1 + of_reference * normal(random), of_reference});
  const auto found = model_bias(values);
  ASSERT_TRUE(found);
  // With 20000 values the mean has an error of 0.05 % and the deviation one of 0.5 %. The expansion
  // of the logarithm adds a relative error of the deviation squared, 0.4 %.
  EXPECT_NEAR(found->bias, bias, 0.002);
  EXPECT_NEAR(found->relative_deviation, of_model, 0.001);
}

TEST(ModelBias, OfFewerThanFiveComparisonsIsNotStated) {
  EXPECT_FALSE(model_bias(with_ratios({1, 1.1, 0.9, 1.2})));
  EXPECT_FALSE(model_bias({}));
}

TEST(ModelBias, IsRefusedOfValuesThatHaveNoLogarithm) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {0.0, -1.0, nan, std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(model_bias({{bad, 1}}), std::invalid_argument) << bad;
    EXPECT_THROW(model_bias({{1, bad}}), std::invalid_argument) << bad;
  }
  EXPECT_THROW(model_bias({{1, 1, -0.1}}), std::invalid_argument);
  EXPECT_THROW(model_bias({{1, 1, nan}}), std::invalid_argument);
}

}  // namespace
}  // namespace slosh::model_bias_test
