#include "verification/series/sample_moments.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "verification/series/distribution.hpp"
#include "verification/series/interval_text.hpp"
#include "verification/series/wave_statistics.hpp"
#include "verification/tests/synthetic_series.hpp"

namespace slosh::sample_moments_test {
namespace {

using Values = std::vector<double>;

TEST(SampleMoments, AreThoseOfASampleByHand) {
  const Values values{1, 2, 6};
  EXPECT_DOUBLE_EQ(mean(values), 3);
  EXPECT_DOUBLE_EQ(rms(values), std::sqrt(41.0 / 3));
  EXPECT_DOUBLE_EQ(rms(without_mean(values)), std::sqrt(14.0 / 3));
  for (const double size : {1e-200, 1e200})  // whose squares are lost
    EXPECT_DOUBLE_EQ(rms({size, 2 * size, 6 * size}) / size, std::sqrt(41.0 / 3));
}

TEST(SampleMoments, LeaveASampleWithoutItsMeanOrAnother) {
  EXPECT_EQ(without_mean({1, 2, 6}), (Values{-2, -1, 3}));
  EXPECT_EQ(minus({1, 2, 6}, {1, 1, 4}), (Values{0, 1, 2}));
}

TEST(SampleMoments, AreNoNumberOfNoSamples) {
  EXPECT_TRUE(std::isnan(mean({})));
  EXPECT_TRUE(std::isnan(rms({})));
}

// Against printed tables (Fisher & Yates) and the normal distribution.
TEST(StudentT, HasTheQuantilesOfPrintedTables) {
  EXPECT_NEAR(t95(1), 12.706, 5e-4);
  EXPECT_NEAR(t95(2), 4.303, 5e-4);
  EXPECT_NEAR(t95(10), 2.228, 5e-4);
  EXPECT_NEAR(t95(1e9), 1.959964, 1e-6);  // the normal distribution's
}

TEST(StudentT, ExceedsItsQuantileInOneOfTwentyDrawsOnEitherSide) {
  for (const double freedom : {1.0, 2.5, 10.0, 1e4}) {
    EXPECT_NEAR(two_sided_p(t95(freedom), freedom), 0.05, 1e-12);
    EXPECT_NEAR(two_sided_p(-t95(freedom), freedom), 0.05, 1e-12);
  }
  EXPECT_DOUBLE_EQ(two_sided_p(0, 3), 1);
}

constexpr double period = 1.3;

// A wave with steep crests and flat troughs about a level of 0.02: 0.1 cos + 0.03 cos of twice the
// frequency.
double steep_wave(double t) {
  return 0.02 + 0.1 * std::cos(two_pi / period * t) + 0.03 * std::cos(2 * two_pi / period * t);
}

TEST(WaveStatistics, GiveMeanAndDeviationOfAKnownWave) {
  const TimeSeries series = sampled(steep_wave, 0, 10 * period);
  const auto wave = wave_statistics(series.time, series.value);
  EXPECT_NEAR(wave.mean, 0.02, 2e-4);  // both ends of the window are counted
  EXPECT_NEAR(wave.deviation, std::sqrt(0.5 * (0.01 + 0.0009)), 2e-4);
}

// A logger that writes nine times as often for a while, here at every crest.
TEST(WaveStatistics, AreThoseOfTheTimeWhereverTheSamplesLieDense) {
  TimeSeries series;
  for (double t = 0; t < 10 * period; t += std::abs(std::remainder(t, period)) < 0.2 ? 1e-3 : 9e-3)
    series.time.push_back(t);
  for (const double t : series.time) series.value.push_back(steep_wave(t));
  EXPECT_GT(mean(series.value), 0.06) << "of the samples";
  const auto wave = wave_statistics(series.time, series.value);
  EXPECT_NEAR(wave.mean, 0.02, 2e-4);
  EXPECT_NEAR(wave.deviation, std::sqrt(0.5 * (0.01 + 0.0009)), 2e-4);
}

TEST(NoiseShare, FindsWhiteNoiseOfAnyStrengthInASteepWave) {
  const auto clean = sampled(steep_wave, 0, 24);
  EXPECT_LT(noise_share(clean), 1e-4);
  const double deviation = wave_statistics(clean.time, clean.value).deviation;
  for (const double strength : {0.02, 0.1, 0.3})
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
      EXPECT_NEAR(noise_share(with_noise(clean, strength * deviation, 0, seed)),
                  strength / std::hypot(1, strength), 0.08 * strength);
}

TEST(NoiseShare, IsNoneOfSmoothDisturbances) {
  // A noise with a correlation time of 0.3 s has a tenth of the deviation and yet is not white.
  const auto clean = sampled(steep_wave, 0, 24);
  const auto disturbed =
      sampled([](double t) { return steep_wave(t) + 0.007 * std::sin(two_pi * t / 0.3); }, 0, 24);
  EXPECT_LT(noise_share(disturbed), 2e-3);
  // A breaker in a twentieth of the samples neither hides noise nor adds any.
  const auto breaking = sampled(
      [](double t) { return steep_wave(t) + (std::fmod(t, period) < 0.05 ? 0.05 : 0); }, 0, 24);
  EXPECT_LT(noise_share(breaking), 2e-3);
}

TEST(NoiseShare, RefusesWhatDoesNotVaryAndTooFewSamples) {
  EXPECT_THROW(noise_share(sampled([](double) { return 0.2; }, 0, 5)), ComparisonError);
  EXPECT_THROW(noise_share(sampled(steep_wave, 0, 0.14)), ComparisonError);
}

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

TEST(IntervalText, EndsTheValueWhereItsIntervalEnds) {
  EXPECT_EQ(interval_text({0.00179, 0.34}), "0.00 ± 0.34");
  EXPECT_EQ(interval_text({-0.287, 0.19}), "-0.29 ± 0.19");
  EXPECT_EQ(interval_text({12.345, 0.0951}), "12.35 ± 0.10");
  EXPECT_EQ(interval_text({5.8412, 0.24}), "5.84 ± 0.24");
  EXPECT_EQ(interval_text({1234.5, 78}), "1230 ± 80");
  EXPECT_EQ(interval_text({3, 6.57}), "3.0 ± 6.6");
  EXPECT_EQ(interval_text({0, 0.5}), "0.00 ± 0.50");
  EXPECT_EQ(interval_text({5.62, 47.3}), "6 ± 47");
  EXPECT_EQ(interval_text({5.62, 4.73}), "6 ± 5");
}

TEST(IntervalText, WritesLongValuesWithoutAPowerOfTen) {
  EXPECT_EQ(interval_text({158312, 0}), "158000");
  EXPECT_EQ(three_digits(-1234.5), "-1230");
  EXPECT_EQ(three_digits(999.6), "1000");
  EXPECT_EQ(three_digits(1.23456e7), "1.23e+07");
  EXPECT_EQ(three_digits(0.00153), "0.00153");
  EXPECT_EQ(three_digits(-0.0), "0");
}

TEST(IntervalText, HasNoNegativeZero) {
  EXPECT_EQ(interval_text({-0.00179, 0.34}), "0.00 ± 0.34");
  EXPECT_EQ(interval_text({-0.0, 0}), "0");
}

TEST(IntervalText, RoundsAnIntervalUpToTheFourthDigitOfTheValue) {
  EXPECT_EQ(interval_text({10.937, 0.0031}), "10.94 ± 0.01");
  EXPECT_EQ(interval_text({25000, 3}), "25000 ± 10");
}

TEST(IntervalText, LeavesOutAnIntervalThatNoShownDigitFeels) {
  EXPECT_EQ(interval_text({10.937, 9.72e-6}), "10.9");
  EXPECT_EQ(interval_text({-6.42e-5, 6.56e-10}), "-6.42e-05");
}

TEST(IntervalText, PutsASmallValueBeforeAPowerOfTen) {
  EXPECT_EQ(interval_text({-6.42e-5, 1.5e-6}), "(-6.42 ± 0.15)e-05");
  EXPECT_EQ(interval_text({1e-9, 4e-7}), "(0.0 ± 4.0)e-07");
}

TEST(IntervalText, GivesAValueWithoutAnIntervalThreeDigits) {
  EXPECT_EQ(interval_text({0.028049, 0}), "0.028");
  EXPECT_EQ(interval_text({9.2437, not_a_number}), "9.24");
  EXPECT_EQ(percent_interval_text({0.01, 0.0034}), "1.0 ± 0.3 %");
}

TEST(IntervalText, SaysThatAnInfiniteIntervalDeterminesNothing) {
  EXPECT_EQ(interval_text({3, infinity}), "not determined");
}

TEST(SlopeText, IsNotDeterminedWhereItsIntervalIncludesZero) {
  EXPECT_EQ(slope_text({-1.65, 52}), "not determined");
  EXPECT_EQ(slope_text({-1.65, 0.22}), "-1.65 ± 0.22");
  EXPECT_EQ(slope_text({-1.654, not_a_number}), "-1.65");
}

}  // namespace
}  // namespace slosh::sample_moments_test
