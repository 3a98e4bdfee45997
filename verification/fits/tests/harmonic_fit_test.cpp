#include "verification/fits/harmonic_fit.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "verification/tests/messages.hpp"
#include "verification/tests/synthetic_series.hpp"

namespace slosh::harmonic_fit_test {
namespace {

constexpr double pi = std::numbers::pi;
// The small-amplitude surge case: forced at 0.3 of the first natural frequency, 20 s.
constexpr double forced = 1.48346, natural = 4.96646;

const std::vector<ToneRequest> both{{"forced", forced, false}, {"natural_1", natural, true}};

TEST(HarmonicFit, RecoversAmplitudePhaseMeanAndTrendOfNonIntegerPeriods) {
  const auto series = sampled(
      [](double t) { return 0.3 + 0.02 * t + 0.009 * std::cos(forced * t + 0.7); }, 1.5, 12.9);
  const auto fit = fit_harmonics(series, {1.5, 12.9}, {{"forced", forced, false}});
  const Tone& tone = fit.tones.at(0);
  EXPECT_EQ(tone.name, "forced");
  EXPECT_NEAR(tone.amplitude.value, 0.009, 1e-12);
  EXPECT_NEAR(tone.phase.value, 0.7, 1e-10);
  EXPECT_NEAR(wrap_angle(tone.phase_at_middle.value - (forced * 7.2 + 0.7)), 0, 1e-10);
  EXPECT_NEAR(fit.mean, 0.3 + 0.02 * 7.2, 1e-12);
  EXPECT_NEAR(fit.trend, 0.02, 1e-12);
  EXPECT_EQ(tone.angular_frequency.half_width, 0);
  EXPECT_EQ(tone.decay_rate.value, 0);
}

TEST(HarmonicFit, RefinesFrequencyAndDecayOfANaturalModeThatStartsElsewhere) {
  const double true_w = 0.97 * natural, true_g = 0.12;
  const auto series = sampled(
      [&](double t) {
        return 0.009 * std::cos(forced * t + 0.7) +
               0.004 * std::exp(-true_g * (t - 2)) * std::cos(true_w * t - 2.0);
      },
      0, 20);
  const auto fit = fit_harmonics(series, {2, 20}, both);
  EXPECT_NEAR(fit.tones[0].amplitude.value, 0.009, 1e-10);
  EXPECT_NEAR(fit.tones[1].angular_frequency.value, true_w, 1e-8);
  EXPECT_NEAR(fit.tones[1].decay_rate.value, true_g, 1e-8);
  EXPECT_NEAR(fit.tones[1].amplitude.value, 0.004, 1e-10);
  EXPECT_NEAR(wrap_angle(fit.tones[1].phase.value + 2.0), 0, 1e-7);
  EXPECT_LT(fit.residual_rms, 1e-10);
}

// The scheme of Li et al. 2010 damps its modes within about a second.
TEST(HarmonicFit, FindsModesThatDecayWithinASecondOfTwentyUnderNoise) {
  const auto clean = sampled(
      [&](double t) {
        return 0.004 * std::sin(forced * t) + 0.005 * std::exp(-t) * std::sin(5.0 * t) +
               0.002 * std::exp(-6 * t) * std::sin(9.5 * t);
      },
      0, 20);
  const auto fit = fit_harmonics(with_noise(clean, 1e-4, 0.8, 3), {0, 20},
                                 {{"forced", forced, false},
                                  {"natural_1", natural, true},
                                  {"natural_2", 9.6, true},
                                  {"natural_3", 12.4, true}});
  const auto holds = [](const Estimate& e, double truth) {
    return std::abs(e.value - truth) <= 2 * e.half_width;
  };
  EXPECT_NEAR(fit.tones[0].amplitude.value, 0.004, 1e-4);
  EXPECT_NEAR(fit.tones[1].angular_frequency.value, 5.0, 0.1);
  EXPECT_NEAR(fit.tones[1].decay_rate.value, 1.0, 0.15);
  EXPECT_TRUE(holds(fit.tones[1].amplitude, 0.005)) << fit.tones[1].amplitude.half_width;
  EXPECT_LT(fit.tones[1].amplitude.half_width, 0.002);
  // There is no third mode: whatever is fitted must not look like a finding.
  EXPECT_GE(fit.tones[3].amplitude.half_width, fit.tones[3].amplitude.value);
}

TEST(HarmonicFit, GivesAModeThatIsNotThereAnIntervalDownToZero) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const auto series =
        with_noise(sampled([](double t) { return 0.01 * std::cos(forced * t); }, 0, 20, 0.05), 1e-3,
                   0.6, seed);
    const Tone mode = fit_harmonics(series, {0, 20}, both).tones[1];
    if (!mode.resolved) {
      EXPECT_GE(mode.amplitude.half_width, mode.amplitude.value);
      EXPECT_EQ(mode.phase.half_width, pi);
      EXPECT_GE(mode.angular_frequency.half_width, 0.1 * natural);
    } else {
      ++found;
    }
  }
  EXPECT_LE(found, 5);
}

TEST(HarmonicFit, DoesNotVouchForAModeFarFromTheRequest) {
  const auto series = sampled(
      [](double t) { return std::cos(forced * t) + 0.5 * std::cos(1.15 * natural * t); }, 0, 20);
  const auto fit = fit_harmonics(series, {0, 20}, both);
  EXPECT_NEAR(fit.tones[0].amplitude.value, 1, 0.05);
  EXPECT_TRUE(fit.tones[0].resolved);
  EXPECT_FALSE(fit.tones[1].resolved);
  EXPECT_GE(fit.tones[1].amplitude.half_width, fit.tones[1].amplitude.value);
  EXPECT_GE(fit.tones[1].angular_frequency.half_width, 0.15 * natural);
}

// The paper's resonant case, forced at 1.3 s beside a natural period of 1.265 s, with a candidate
// whose forced mode is 10 % low and 0.1 period late and whose natural mode is 15 % low. One tone
// fitted to 20 s of the beating signals also takes part of the other. Two tones fitted to a window
// that resolves them are both found.
TEST(HarmonicFit, RecoversLagAndAmplitudeOfABeatingSignalOnlyWithBothTones) {
  const double w = two_pi / 1.3, ratio = w / natural;
  const auto reference =
      sampled([&](double t) { return std::sin(w * t) - ratio * std::sin(natural * t); }, 0, 60);
  const auto candidate = sampled(
      [&](double t) {
        return 0.9 * std::sin(w * t - 0.1 * two_pi) - 0.85 * ratio * std::sin(natural * t);
      },
      0, 60);
  const auto lag_and_error = [&](TimeWindow window, const std::vector<ToneRequest>& modes) {
    const Tone c = fit_harmonics(candidate, window, modes).tones[0];
    const Tone r = fit_harmonics(reference, window, modes).tones[0];
    return std::pair{wrap_angle(r.phase.value - c.phase.value) / two_pi,
                     c.amplitude.value / r.amplitude.value - 1};
  };
  const auto right = lag_and_error({0, 60}, {{"forced", w, false}, {"natural_1", natural, true}});
  EXPECT_NEAR(right.first, 0.100, 1e-7);
  EXPECT_NEAR(right.second, -0.10, 1e-7);
  const Tone alone = fit_harmonics(candidate, {0, 20}, {{"forced", w, false}}).tones[0];
  ASSERT_TRUE(alone.beside.has_value());
  EXPECT_NEAR(*alone.beside, natural, 0.05 * natural);
  EXPECT_GE(alone.amplitude.half_width, alone.amplitude.value);
  EXPECT_EQ(alone.phase.half_width, pi);
}

std::string error_of(const TimeSeries& series, TimeWindow window,
                     const std::vector<ToneRequest>& requests) {
  return message_of<ComparisonError>([&] { fit_harmonics(series, window, requests); });
}

TEST(HarmonicFit, RefusesAWindowThatCannotResolveTheTones) {
  const auto series = sampled([](double t) { return std::cos(t); }, 0, 20);
  const std::vector<ToneRequest> resonant{{"forced", two_pi / 1.3, false},
                                          {"natural_1", natural, true}};
  const std::string message = error_of(series, {0, 20}, resonant);
  EXPECT_TRUE(holds(message, "20 s cannot resolve forced (0.7692 Hz) from natural_1 (0.7904 Hz)"));
  EXPECT_TRUE(holds(message, "more than 47.1"));
  EXPECT_NE(error_of(series, {0, 4}, both),
            "");  // less than one forced period: not resolved from the mean
  EXPECT_EQ(error_of(series, {0, 5}, both), "");
  EXPECT_NE(error_of(series, {0, 20}, {both[1], both[1]}), "");
  EXPECT_NE(error_of(series, {0, 20}, {{"forced", std::nan(""), false}}), "");
}

// Samples every 0.1 s are 42 and 13 in a period of the wave's two modes, and 6.5 in that of the
// next natural one.
TEST(HarmonicFit, WantsTenSamplesInAPeriodOfTheWaveAndFourInThatOfAHigherMode) {
  const double higher = 9.6;
  const std::vector<ToneRequest> three{
      {"forced", forced, false}, {"natural_1", natural, true}, {"natural_2", higher, true}};
  const auto wave = [&](double t) {
    return 0.009 * std::cos(forced * t + 0.7) + 0.004 * std::cos(natural * t - 2.0) +
           0.0005 * std::cos(higher * t + 1.0);
  };
  const auto fit = fit_harmonics(sampled(wave, 0, 20, 0.1), {0, 20}, three);
  EXPECT_NEAR(fit.tones.at(1).amplitude.value, 0.004, 1e-8);
  EXPECT_NEAR(fit.tones.at(2).amplitude.value, 0.0005, 1e-8);
  EXPECT_TRUE(holds(error_of(sampled(wave, 0, 20, 0.14), {0, 20}, three),
                    "expected intervals up to 0.127 s"));
  const std::vector<ToneRequest> high{{"natural_1", natural, true}, {"natural_9", 40.0, true}};
  EXPECT_TRUE(holds(error_of(sampled(wave, 0, 20, 0.1), {0, 20}, high),
                    "expected intervals up to 0.0393 s"));
}

TEST(HarmonicFit, RefusesSeriesThatAreNotSound) {
  const auto sound = sampled([](double t) { return std::cos(t); }, 0, 20);
  EXPECT_EQ(error_of(sound, {0, 20}, both), "");
  auto poisoned = sound;
  poisoned.value[700] = std::nan("");
  EXPECT_TRUE(holds(error_of(poisoned, {0, 20}, both), "not finite"));
  poisoned = sound;
  poisoned.value[700] = std::numeric_limits<double>::infinity();
  EXPECT_NE(error_of(poisoned, {0, 20}, both), "");
  poisoned = sound;
  std::swap(poisoned.time[10], poisoned.time[11]);
  EXPECT_TRUE(holds(error_of(poisoned, {0, 20}, both), "do not increase"));
  poisoned = sound;
  poisoned.value.pop_back();
  EXPECT_NE(error_of(poisoned, {0, 20}, both), "");
  poisoned = sound;  // a hole of 0.5 s
  poisoned.time.erase(poisoned.time.begin() + 500, poisoned.time.begin() + 550);
  poisoned.value.erase(poisoned.value.begin() + 500, poisoned.value.begin() + 550);
  EXPECT_TRUE(holds(error_of(poisoned, {0, 20}, both), "no sample between"));
  EXPECT_TRUE(holds(error_of(sound, {15, 25}, both), "covers 0 s to 20 s"));
  EXPECT_NE(error_of(sound, {12, 3}, both), "");
  EXPECT_NE(error_of({"empty", "m", {}, {}}, {0, 20}, both), "");
}

}  // namespace
}  // namespace slosh::harmonic_fit_test
