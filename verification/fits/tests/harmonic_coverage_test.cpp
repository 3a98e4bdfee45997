// How often the intervals of fits hold the truth: hundreds of realisations each.
#include <gtest/gtest.h>

#include <array>

#include "verification/fits/harmonic_fit.hpp"
#include "verification/tests/synthetic_series.hpp"

namespace slosh::harmonic_coverage_test {
namespace {

// The share of 400 realisations whose 95 % interval holds the truth, for (forced amplitude, forced
// phase, natural amplitude, frequency, decay rate, phase at the middle).
std::array<double, 6> coverage(double correlation) {
  constexpr int realisations = 400;
  constexpr double forced = 1.48346, w = 5.1, g = 0.08;
  const std::vector<ToneRequest> both{{"forced", forced, false}, {"natural_1", 4.96646, true}};
  const auto clean = sampled(
      [&](double t) {
        return 0.001 * t + 0.010 * std::cos(forced * t + 1) +
               0.008 * std::exp(-g * t) * std::cos(w * t + 2);
      },
      0, 20, 0.05);
  const std::array<double, 6> truth{0.010, 1, 0.008, w, g, std::remainder(w * 10 + 2, two_pi)};
  std::array<double, 6> covered{};
  for (int i = 0; i < realisations; ++i) {
    const auto fit = fit_harmonics(
        with_noise(clean, 1e-3, correlation, static_cast<std::uint64_t>(i) + 1), {0, 20}, both);
    const Tone &f = fit.tones[0], &n = fit.tones[1];
    const std::array<Estimate, 6> estimates{f.amplitude,         f.phase,      n.amplitude,
                                            n.angular_frequency, n.decay_rate, n.phase_at_middle};
    for (std::size_t k = 0; k < estimates.size(); ++k) {
      const double error = std::abs(wrap_angle(estimates[k].value - truth[k]));
      if (error <= estimates[k].half_width) covered[k] += 1.0 / realisations;
    }
  }
  return covered;
}

TEST(HarmonicFit, CoversTheTruthNineteenTimesInTwentyUnderWhiteNoise) {
  for (const double share : coverage(0)) {
    EXPECT_GE(share, 0.90);
    EXPECT_LE(share, 0.99);
  }
}

TEST(HarmonicFit, CoversTheTruthNineteenTimesInTwentyUnderCorrelatedNoise) {
  for (const double correlation : {0.7, 0.9}) {
    for (const double share : coverage(correlation)) {
      EXPECT_GE(share, 0.90) << correlation;
      EXPECT_LE(share, 0.99) << correlation;
    }
  }
}

}  // namespace
}  // namespace slosh::harmonic_coverage_test
