#include "verification/fits/harmonic_fit.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <string>

#include "verification/fits/dominant_sine.hpp"
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
  EXPECT_TRUE(holds(error_of(series, {0, 20}, {both[1], both[1]}), "; no window can"));
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

constexpr double omega = 3.84;                     // [rad/s]
constexpr TimeWindow window{1, 13};                // 7.3 periods
constexpr double bin = 2 * std::numbers::pi / 12;  // [rad/s], the resolution of this window

// A sample every 10 ms from 0 to 14 s, with an interval that varies.
TimeSeries sampled(const std::function<double(double)>& motion) {
  TimeSeries series{"roll.csv", "rad", {}, {}};
  for (double t = 0; t <= 14; t += 0.01 + 0.004 * std::sin(9 * t)) {
    series.time.push_back(t);
    series.value.push_back(motion(t));
  }
  return series;
}

double sine(double t) { return 0.07 * std::sin(omega * t + 0.4); }

std::string complaint(const TimeSeries& series, TimeWindow in = window) {
  return message_of<ComparisonError>([&] { dominant_sine(series, in); });
}

TEST(DominantSine, OfASineIsThatSine) {
  const DominantSine found = dominant_sine(sampled(sine), window);
  EXPECT_NEAR(found.angular_frequency.value, omega, 1e-6);
  EXPECT_LT(found.angular_frequency.half_width, 1e-4);
  EXPECT_LT(found.rest, 1e-5);
}

TEST(DominantSine, IsFoundWhateverTheMeanAndTheDrift) {
  const DominantSine found =
      dominant_sine(sampled([](double t) { return 5 + 0.1 * t + sine(t); }), window);
  EXPECT_NEAR(found.angular_frequency.value, omega, 1e-6);
}

TEST(DominantSine, OfANoisyTableIsWithinItsInterval) {
  int inside = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    std::mt19937 generator(seed);
    std::normal_distribution<double> noise(0, 0.01);
    const DominantSine found =
        dominant_sine(sampled([&](double t) { return sine(t) + noise(generator); }), window);
    EXPECT_NEAR(found.angular_frequency.value, omega, 5e-3);
    EXPECT_NEAR(found.rest, 0.01 / (0.07 / std::numbers::sqrt2), 0.02);
    inside += std::abs(found.angular_frequency.value - omega) <= found.angular_frequency.half_width;
  }
  // Of 40 intervals of 95 %, 33 or fewer hold the truth once in 400 times.
  EXPECT_GE(inside, 34);
}

TEST(DominantSine, TellsTheRestOfAHarmonic) {
  const DominantSine found = dominant_sine(
      sampled([](double t) { return sine(t) + 0.014 * std::sin(3 * omega * t); }), window);
  EXPECT_NEAR(found.angular_frequency.value, omega, 5e-3);
  EXPECT_NEAR(found.rest, 0.2, 0.005);
}

TEST(DominantSine, IsNoneOfTwoSines) {
  const std::string message =
      complaint(sampled([](double t) { return sine(t) + 0.05 * std::sin(7.1 * t); }));
  EXPECT_TRUE(holds(message, "roll.csv: the rest beside the sine of 0.611"));
  EXPECT_TRUE(holds(message, "is 0.71"));
  EXPECT_TRUE(holds(message, "has at most 0.32; the next peak is at 1.1"));
}

// Half a bin apart, two sines beat as one sine whose amplitude changes. A weak one beside it is
// part of the rest. With r the ratio of their amplitudes and d the difference of their
// frequencies, the frequency of the sum differs from the strong one's by r d / (1 - r) at most.
TEST(DominantSine, IsNoneOfTwoLikeSinesThatTheWindowCannotTellApart) {
  const auto beside = [](double amplitude) {
    return sampled(
        [amplitude](double t) { return sine(t) + amplitude * std::sin((omega + 0.6 * bin) * t); });
  };
  EXPECT_NE(complaint(beside(0.05)), "");
  const DominantSine found = dominant_sine(beside(0.02), window);
  const double ratio = 0.02 / 0.07;
  EXPECT_NEAR(found.angular_frequency.value, omega, 0.6 * bin * ratio / (1 - ratio));
  EXPECT_GT(found.rest, 0.1);
}

TEST(DominantSine, IsNoneOfNoiseOrOfASweep) {
  std::mt19937 generator(7);
  std::normal_distribution<double> noise(0, 1);
  EXPECT_NE(complaint(sampled([&](double) { return noise(generator); })), "");
  EXPECT_NE(complaint(sampled([](double t) { return std::sin((2 + 0.3 * t) * t); })), "");
}

TEST(DominantSine, IsNoneOfAMotionThatDoesNotSwing) {
  EXPECT_NE(complaint(sampled([](double) { return 0.1; })), "");
  EXPECT_NE(complaint(sampled([](double t) { return std::exp(-t); })), "");
}

TEST(DominantSine, NeedsThreePeriods) {
  const std::string message = complaint(sampled(sine), {1, 1 + 2.5 * 2 * std::numbers::pi / omega});
  EXPECT_TRUE(holds(message, "periods in the window, and three or more tell a frequency"));
}

TEST(DominantSine, PassesUpToTheTolerancesRest) {
  const auto beside = [](double share) {
    return sampled([share](double t) { return sine(t) + share * 0.07 * std::sin(7.1 * t); });
  };
  EXPECT_EQ(complaint(beside(0.30)), "");
  EXPECT_NE(complaint(beside(0.34)), "");
  EXPECT_NEAR(largest_rest, std::sqrt(1.05 * 1.05 - 1), 5e-5);
}

}  // namespace
}  // namespace slosh::harmonic_fit_test
