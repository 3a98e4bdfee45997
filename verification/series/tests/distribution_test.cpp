#include "verification/series/distribution.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace slosh::distribution_test {
namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Distribution of(std::vector<double> values) { return {"peak 1", std::move(values)}; }

// The peaks of 60 repeats, with the skewness of an impact's peaks.
std::vector<double> peaks(unsigned seed, double median = 4000) {
  std::mt19937_64 generator(seed);
  std::lognormal_distribution<double> peak(std::log(median), 0.3);
  std::vector<double> values(60);
  std::generate(values.begin(), values.end(), [&] { return peak(generator); });
  return values;
}

std::vector<double> mapped(std::vector<double> values, double factor, double shift) {
  for (double& value : values) value = factor * value + shift;
  return values;
}

TEST(Distribution, HasTheMeanAndDeviationOfTheSampleInAnyOrder) {
  const Distribution sample = of({9, 2, 4, 4, 5, 5, 7, 4});  // squares of deviations: 32
  EXPECT_DOUBLE_EQ(sample.mean(), 5);
  EXPECT_DOUBLE_EQ(sample.standard_deviation(), std::sqrt(32.0 / 7));
  EXPECT_THROW(of({5}).standard_deviation(), ComparisonError);
  EXPECT_EQ(of({5, 5}).standard_deviation(), 0);
}

TEST(Distribution, HasQuantilesBetweenItsSortedValues) {
  const Distribution sample = of({40, 10, 30, 20});  // places 1, 2, 3, 4 at p = 0, 1/3, 2/3, 1
  EXPECT_DOUBLE_EQ(sample.quantile(0), 10);
  EXPECT_DOUBLE_EQ(sample.quantile(0.25), 17.5);
  EXPECT_DOUBLE_EQ(sample.quantile(0.5), 25);
  EXPECT_DOUBLE_EQ(sample.quantile(0.9), 37);
  EXPECT_DOUBLE_EQ(sample.quantile(1), 40);
  EXPECT_DOUBLE_EQ(of({7}).quantile(0.3), 7);
  for (const double wrong : {-0.01, 1.01, nan_value})
    EXPECT_THROW(sample.quantile(wrong), ComparisonError);
}

TEST(Distribution, TellsWhereAValueFalls) {
  const Distribution sample = of({1, 2, 2, 5});
  EXPECT_EQ(sample.percentile(0), 0);
  EXPECT_EQ(sample.percentile(1), 12.5);
  EXPECT_EQ(sample.percentile(2), 50);
  EXPECT_EQ(sample.percentile(3), 75);
  EXPECT_EQ(sample.percentile(6), 100);
  EXPECT_THROW(sample.percentile(nan_value), ComparisonError);
}

TEST(Distribution, HoldsNineTenthsBetweenTheEndsOfItsCentralInterval) {
  std::vector<double> values;
  for (int i = 0; i <= 100; ++i) values.push_back(i);
  EXPECT_DOUBLE_EQ(of(values).central_90_percent().low, 5);
  EXPECT_DOUBLE_EQ(of(values).central_90_percent().high, 95);
  values.resize(20);
  EXPECT_DOUBLE_EQ(of(values).central_90_percent().low, 0.95);
  values.resize(19);
  EXPECT_THROW(of(values).central_90_percent(), ComparisonError);
}

TEST(Distribution, RefusesNoValuesAndValuesThatAreNone) {
  EXPECT_THROW(of({}), ComparisonError);
  for (const double wrong : {nan_value, infinity, -infinity}) {
    try {
      of({1, 2, wrong, 4});
      FAIL() << wrong;
    } catch (const ComparisonError& error) {
      EXPECT_EQ(std::string(error.what()).rfind("peak 1: value 3 of 4 is not finite: ", 0), 0U);
    }
  }
}

TEST(Distribution, ScalesAndShiftsWithItsValues) {
  const Distribution sample = of(peaks(1)), moved = of(mapped(peaks(1), 0.01, 3));
  EXPECT_NEAR(moved.mean(), 0.01 * sample.mean() + 3, 1e-12);
  EXPECT_NEAR(moved.standard_deviation(), 0.01 * sample.standard_deviation(), 1e-12);
  EXPECT_NEAR(moved.quantile(0.37), 0.01 * sample.quantile(0.37) + 3, 1e-12);
  EXPECT_NEAR(moved.central_90_percent().high, 0.01 * sample.central_90_percent().high + 3, 1e-12);
  EXPECT_EQ(moved.percentile(0.01 * 4321 + 3), sample.percentile(4321));
}

}  // namespace
}  // namespace slosh::distribution_test
