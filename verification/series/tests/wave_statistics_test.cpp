#include "verification/series/wave_statistics.hpp"

#include <gtest/gtest.h>

#include "verification/tests/synthetic_series.hpp"

namespace slosh::wave_statistics_test {
namespace {

constexpr double period = 1.3;

// A wave with steep crests and flat troughs about a level of 0.02: 0.1 cos + 0.03 cos of twice the
// frequency.
double steep_wave(double t) {
  return 0.02 + 0.1 * std::cos(two_pi / period * t) + 0.03 * std::cos(2 * two_pi / period * t);
}

TEST(WaveStatistics, GiveMeanAndDeviationOfAKnownWave) {
  const auto wave = wave_statistics(sampled(steep_wave, 0, 10 * period).value);
  EXPECT_NEAR(wave.mean, 0.02, 2e-4);  // both ends of the window are counted
  EXPECT_NEAR(wave.deviation, std::sqrt(0.5 * (0.01 + 0.0009)), 2e-4);
}

TEST(NoiseShare, FindsWhiteNoiseOfAnyStrengthInASteepWave) {
  const auto clean = sampled(steep_wave, 0, 24);
  EXPECT_LT(noise_share(clean), 1e-4);
  const double deviation = wave_statistics(clean.value).deviation;
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

}  // namespace
}  // namespace slosh::wave_statistics_test
