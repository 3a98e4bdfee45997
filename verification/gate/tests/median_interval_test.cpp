// The interval of a median, counted against known truth.
#include "verification/gate/distributions/median_interval.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "verification/gate/tests/random_peaks.hpp"

namespace slosh::median_interval_test {
namespace {

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
}  // namespace slosh::median_interval_test
