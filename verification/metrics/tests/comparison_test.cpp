#include "verification/metrics/comparison.hpp"

#include <gtest/gtest.h>

#include <ctime>

#include "verification/tests/messages.hpp"
#include "verification/tests/synthetic_series.hpp"

namespace slosh::comparison_test {
namespace {

constexpr double forced = 1.48346, natural = 4.96646;
constexpr double forced_period = two_pi / forced;
constexpr TimeWindow window{0, 20};
const std::vector<ToneRequest> modes{{"forced", forced, false}, {"natural_1", natural, true}};

double wave(double t) { return 0.003 * std::sin(forced * t) - 0.008 * std::sin(natural * t + 0.1); }

const TimeSeries reference = sampled(wave, 0, 20);

std::string error_of(const TimeSeries& candidate, const TimeSeries& against,
                     TimeWindow over = window, const std::vector<ToneRequest>& of = modes) {
  return message_of<ComparisonError>([&] { compare(candidate, against, over, of); });
}

TEST(Comparison, FindsNoDifferenceBetweenASeriesAndItself) {
  const auto result = compare(reference, reference, window, modes);
  EXPECT_EQ(result.quantity, "elevation@right");
  EXPECT_EQ(result.unit, "m");
  ASSERT_EQ(result.modes.size(), 2U);
  for (const auto& mode : result.modes) {
    EXPECT_EQ(mode.amplitude_error.value, 0);
    EXPECT_EQ(mode.phase_lag.value, 0);
    EXPECT_EQ(mode.frequency_error.value, 0);
  }
  EXPECT_EQ(result.normalised_rms.value, 0);
  EXPECT_EQ(result.maximum_residual, 0);
  EXPECT_EQ(result.residual.time.size(), reference.time.size());
}

TEST(Comparison, ReportsALateCandidateAsAPositiveLagInEveryUnit) {
  const double lag = 0.05 * forced_period;
  const auto late = sampled([&](double t) { return wave(t - lag); }, 0, 20);
  const auto result = compare(late, reference, window, modes);
  const auto& mode = result.modes[0];
  EXPECT_NEAR(mode.phase_lag.value, lag, 1e-8);
  EXPECT_NEAR(mode.phase_lag_periods.value, 0.05, 1e-8);
  EXPECT_NEAR(mode.phase_lag_degrees.value, 18, 1e-6);
  EXPECT_NEAR(result.modes[1].phase_lag.value, lag, 1e-7);
  EXPECT_NEAR(result.cross_correlation_lag, lag, 2e-3);
  EXPECT_NEAR(compare(reference, late, window, modes).modes[0].phase_lag.value, -lag, 1e-8);
}

TEST(Comparison, TellsTheDifferenceThatIsLeftWithoutAnOffset) {
  const auto shifted = [](double error) {
    return sampled([=](double t) { return (1 + error) * wave(t) + 0.01; }, 0, 20);
  };
  const double rest = normalised_rms_without_offset(compare(shifted(0), reference, window, modes));
  EXPECT_NEAR(rest, 0, 1e-12);
  const auto both = compare(shifted(0.05), reference, window, modes);
  EXPECT_GT(both.normalised_rms.value, 1);
  EXPECT_NEAR(normalised_rms_without_offset(both), 0.05, 1e-3);
  EXPECT_EQ(normalised_rms_without_offset(compare(reference, reference, window, modes)), 0);
}

TEST(Comparison, ReportsAScaledCandidateAsAnAmplitudeErrorOfEveryMode) {
  const auto high = sampled([](double t) { return 1.05 * wave(t); }, 0, 20);
  const auto result = compare(high, reference, window, modes);
  for (const auto& mode : result.modes) {
    EXPECT_NEAR(mode.amplitude_error.value, 0.05, 1e-9);
    EXPECT_NEAR(mode.phase_lag.value, 0, 1e-9);
  }
  EXPECT_NEAR(result.sprague_geers_magnitude.value, 0.05, 1e-9);
  EXPECT_NEAR(result.sprague_geers_phase.value, 0, 1e-6);
  EXPECT_NEAR(result.normalised_rms.value, 0.05, 1e-3);
  EXPECT_NEAR(compare(reference, high, window, modes).modes[0].amplitude_error.value, 1 / 1.05 - 1,
              1e-9);
}

TEST(Comparison, TellsAFrequencyErrorAndADecayOfTheNaturalModeFromTheForcedOne) {
  const auto candidate = sampled(
      [](double t) {
        return 0.003 * std::sin(forced * t) -
               0.008 * std::exp(-0.05 * t) *
                   std::sin(1.01 * natural * (t - 10) + natural * 10 + 0.1);
      },
      0, 20);
  const auto result = compare(candidate, reference, window, modes);
  EXPECT_NEAR(result.modes[0].amplitude_error.value, 0, 1e-8);
  EXPECT_EQ(result.modes[0].frequency_error.value, 0);
  EXPECT_NEAR(result.modes[1].frequency_error.value, 0.01, 1e-8);
  EXPECT_NEAR(result.modes[1].decay_rate.value, 0.05, 1e-8);
  EXPECT_NEAR(result.modes[1].phase_lag.value, 0, 1e-8);  // in step at the window's middle
  EXPECT_NEAR(result.modes[1].amplitude_error.value, 0, 1e-8);
  const auto decaying = [](double rate) {
    return sampled([rate](double t) { return 0.01 * std::exp(-rate * t) * std::cos(natural * t); },
                   0, 20);
  };
  const auto both =
      compare_modes(decaying(0.06), decaying(0.05), window, {{"natural_1", natural, true}});
  EXPECT_NEAR(both.at(0).decay_error.value, 0.2, 1e-7);
  EXPECT_NEAR(both[0].frequency_error.value, 0, 1e-8);
}

TEST(Comparison, KeepsDriftAndOffsetOutOfTheModesButInTheResidual) {
  const auto drifting = sampled([](double t) { return wave(t) + 0.001 + 1e-4 * t; }, 0, 20);
  const auto result = compare(drifting, reference, window, modes);
  EXPECT_NEAR(result.modes[0].amplitude_error.value, 0, 1e-9);
  EXPECT_NEAR(result.modes[0].phase_lag.value, 0, 1e-9);
  EXPECT_NEAR(result.cross_correlation_lag, 0, 1e-3);
  EXPECT_NEAR(result.maximum_residual, 0.003, 1e-12);
}

// A component that no fitted mode takes of either series.
double higher_mode(double t) { return 0.002 * std::sin(9.1 * t + 0.3); }

TEST(Comparison, IsNotMadeUncertainByWhatBothSeriesShowAlike) {
  const auto both = with_noise(reference, 3e-4, 0.9, 1);
  auto high = both;
  for (double& value : high.value) value *= 1.05;
  const auto result = compare(high, both, window, modes);
  for (const auto& mode : result.modes) {
    EXPECT_GT(mode.candidate.amplitude.half_width, 1e-5);
    EXPECT_LT(mode.amplitude_error.half_width, 1e-9);
    EXPECT_LT(mode.phase_lag_degrees.half_width, 1e-6);
    EXPECT_LT(mode.frequency_error.half_width, 1e-9);
  }
}

TEST(Comparison, IsNeitherMovedNorMadeUncertainByAToneThatOneSeriesAloneShows) {
  const auto alone = sampled([](double t) { return wave(t) + higher_mode(t); }, 0, 20);
  const auto result = compare(alone, reference, window, modes);
  for (const auto& mode : result.modes) {
    EXPECT_NEAR(mode.amplitude_error.value, 0, 1e-3);
    EXPECT_LT(mode.amplitude_error.half_width, 1e-3);
  }
}

// A tone that no request names, alike in both: 1.4 spectral bins from the forcing, 0.6 of its
// height.
struct SharedTone {
  double frequency = 0.8, beat = 0.95, height = 0.6, gain = 1.06, lag_degrees = 20;
  double length = 9.37;

  double unnamed(double t) const { return height * std::cos(two_pi * beat * t + 1); }
  TimeSeries candidate() const {
    return sampled(
        [this](double t) {
          return gain * std::cos(two_pi * frequency * t - two_pi * lag_degrees / 360) + unnamed(t);
        },
        0, length);
  }
  TimeSeries reference() const {
    return sampled([this](double t) { return std::cos(two_pi * frequency * t) + unnamed(t); }, 0,
                   length);
  }
  std::vector<ToneRequest> forced() const { return {{"forced", two_pi * frequency, false}}; }
};

TEST(ComparisonOfASharedTone, IsThatOfTheNamedToneAlone) {
  for (const double lag_degrees : {0.0, 20.0, -60.0, 120.0})
    for (const double gain : {0.9, 1.06}) {
      const SharedTone tone{.gain = gain, .lag_degrees = lag_degrees};
      const auto mode =
          compare(tone.candidate(), tone.reference(), {0, 9.37}, tone.forced()).modes[0];
      ASSERT_TRUE(mode.resolved());
      EXPECT_NEAR(mode.amplitude_error.value, gain - 1, 1e-6) << lag_degrees;
      EXPECT_NEAR(mode.phase_lag_degrees.value, lag_degrees, 1e-4);
      EXPECT_LE(std::abs(mode.amplitude_error.value - (gain - 1)),
                mode.amplitude_error.half_width + 1e-10);
      EXPECT_LT(mode.amplitude_error.half_width, 1e-3);
      EXPECT_EQ(mode.amplitude_error.value,
                mode.candidate.amplitude.value / mode.reference.amplitude.value - 1);
    }
}

TEST(ComparisonOfASharedTone, FollowsACandidateThatIsScaledShiftedOrSpoilt) {
  const SharedTone tone;
  const auto right = tone.candidate();
  const auto error = [&](TimeSeries candidate) {
    return compare(candidate, tone.reference(), {0, 9.37}, tone.forced())
        .modes[0]
        .amplitude_error.value;
  };
  TimeSeries changed = right;
  for (double& value : changed.value) value = 1000 * value + 7;
  EXPECT_NEAR(error(changed), 1059, 1e-2);
  changed = right;
  changed.value[400] = std::nan("");
  EXPECT_THROW(error(changed), ComparisonError);
  changed = right;
  changed.time.resize(800);
  changed.value.resize(800);
  EXPECT_THROW(error(changed), ComparisonError);
}

TEST(ComparisonOfSharedNoise, IsUncertainByWhatALagLeavesOfIt) {
  int held = 0;
  constexpr int trials = 100;
  double widest = 0;
  for (int seed = 1; seed <= trials; ++seed) {
    const auto noise = with_noise(sampled([](double) { return 0; }, 0, 20), 0.1, 0.9,
                                  static_cast<std::uint64_t>(seed));
    auto late = sampled([](double t) { return 1.02 * std::cos(forced * t - 0.5); }, 0, 20);
    auto early = sampled([](double t) { return std::cos(forced * t); }, 0, 20);
    for (std::size_t i = 0; i < noise.value.size(); ++i) {
      late.value[i] += noise.value[i];
      early.value[i] += noise.value[i];
    }
    const Estimate error =
        compare_modes(late, early, window, {{"forced", forced, false}}).at(0).amplitude_error;
    held += std::abs(error.value - 0.02) <= error.half_width;
    widest = std::max(widest, error.half_width);
  }
  EXPECT_GE(held, 0.88 * trials);
  EXPECT_LT(widest, 0.08);  // of independent noise: 0.1
}

TEST(Comparison, DoesNotTellATooNearBeatOfTheCandidateFromTheForcing) {
  const double beat = forced + 0.5 * two_pi / 20;  // half a spectral bin
  const auto beating =
      sampled([&](double t) { return wave(t) + 0.0006 * std::sin(beat * t + 1); }, 0, 20);
  const auto result = compare(beating, reference, window, modes);
  EXPECT_FALSE(result.modes[0].resolved());
  ASSERT_TRUE(result.modes[0].beside.has_value());
  EXPECT_NEAR(*result.modes[0].beside, beat, 0.5 * two_pi / 20);
}

TEST(Comparison, DifferencesHoldTheTruthAsOftenAsTheySay) {
  int held = 0;
  constexpr int trials = 200;
  const auto low = sampled([](double t) { return 0.9 * wave(t); }, 0, 20, 0.1);
  const auto right = sampled(wave, 0, 20, 0.1);
  for (int seed = 1; seed <= trials; ++seed) {
    const auto one = with_noise(low, 3e-4, 0.9, static_cast<std::uint64_t>(seed));
    const auto other = with_noise(right, 3e-4, 0.9, static_cast<std::uint64_t>(seed + trials));
    const Estimate error = compare_modes(one, other, window, modes).at(1).amplitude_error;
    held += std::abs(error.value + 0.1) <= error.half_width;
  }
  EXPECT_GE(held, 0.90 * trials);  // 95 % but for four standard deviations of the count
  EXPECT_LE(held, trials);
}

TEST(Comparison, IntervalsHoldTheTruthUnderNoise) {
  const double lag = 0.02;
  const auto clean = sampled([&](double t) { return 0.9 * wave(t - lag); }, 0, 20);
  const auto result = compare(with_noise(clean, 5e-4, 0.9, 11), reference, window, modes);
  for (const auto& mode : result.modes) {
    EXPECT_LE(std::abs(mode.amplitude_error.value + 0.1), 1.5 * mode.amplitude_error.half_width);
    EXPECT_LE(std::abs(mode.phase_lag.value - lag), 1.5 * mode.phase_lag.half_width);
    EXPECT_GT(mode.amplitude_error.half_width, 0.001);
    EXPECT_LT(mode.amplitude_error.half_width, 0.2);
  }
  EXPECT_GT(result.normalised_rms.value, 0.1);
}

TEST(Comparison, SurvivesACandidateWhoseNaturalModeIsGone) {
  const auto damped = sampled(
      [](double t) {
        return 0.003 * std::sin(forced * t) - 0.008 * std::exp(-1.2 * t) * std::sin(natural * t);
      },
      0, 20);
  const auto result = compare(with_noise(damped, 1e-4, 0.8, 5), reference, {8, 20}, modes);
  EXPECT_NEAR(result.modes[0].amplitude_error.value, 0, 0.03);
  const auto& gone = result.modes[1];
  EXPECT_GE(gone.candidate.amplitude.half_width, gone.candidate.amplitude.value);
  EXPECT_NEAR(gone.phase_lag_periods.half_width, 0.5, 1e-12);
}

TEST(Comparison, InterpolatesACandidateOfOtherSampling) {
  auto candidate = sampled(wave, 0.003, 20.003, 0.0137);
  const auto result = compare(candidate, reference, window, modes);
  EXPECT_LT(result.normalised_rms.value, 1e-4);
  EXPECT_NEAR(result.modes[0].phase_lag.value, 0, 1e-8);
  EXPECT_GE(result.residual.time.size(), reference.time.size() - 4);
}

TEST(Comparison, MeasuresSpragueAndGeersPhaseOfAQuarterPeriodAsOneHalf) {
  const auto sine = sampled([](double t) { return std::sin(two_pi * t); }, 0, 20);
  const auto cosine = sampled([](double t) { return std::cos(two_pi * t); }, 0, 20);
  const auto result = compare(cosine, sine, window, {{"forced", two_pi, false}});
  EXPECT_NEAR(result.sprague_geers_phase.value, 0.5, 1e-6);
  EXPECT_NEAR(result.modes[0].phase_lag_periods.value, -0.25, 1e-9);
  EXPECT_NEAR(result.cross_correlation_lag, -0.25, 5e-4);
}

TEST(Comparison, RefusesWhatCannotBeCompared) {
  EXPECT_EQ(error_of(reference, reference), "");
  auto poisoned = reference;
  poisoned.value[1000] = std::nan("");
  EXPECT_TRUE(holds(error_of(poisoned, reference), "candidate elevation@right"));
  EXPECT_TRUE(holds(error_of(reference, poisoned), "reference elevation@right"));
  poisoned = reference;
  poisoned.unit = "mm";
  EXPECT_TRUE(holds(error_of(poisoned, reference), "mm"));
  EXPECT_TRUE(holds(error_of(sampled(wave, 0, 12), reference), "covers 0 s to 12 s"));
  EXPECT_NE(error_of(reference, sampled(wave, 0, 12)), "");
  EXPECT_NE(error_of(sampled(wave, 0, 19.97), reference), "");
  EXPECT_EQ(error_of(sampled(wave, 0, 19.99), reference), "");
  EXPECT_NE(error_of(sampled(wave, 30, 50), reference), "");
  const auto still = sampled([](double) { return 0.35; }, 0, 20);
  EXPECT_TRUE(holds(error_of(still, reference), "constant"));
  const auto vanishing = sampled([](double t) { return 1e-200 * wave(t); }, 0, 20);
  EXPECT_TRUE(holds(error_of(vanishing, reference), "constant"));
  EXPECT_NE(error_of(reference, reference, {0, 3}), "");
  const auto faint = sampled([](double t) { return 1e-17 * wave(t); }, 0, 20);
  EXPECT_TRUE(holds(error_of(reference, faint), "expected a billionth of that at least"));
  EXPECT_EQ(error_of(faint, faint), "");
  EXPECT_EQ(error_of(faint, reference), "");
}

TEST(ComparisonWithAConstant, IsOfTheOffsetAndTheResidualAlone) {
  const auto still = sampled([](double) { return 0.35; }, 0, 20);
  for (const auto& of : {modes, std::vector<ToneRequest>{}}) {
    const auto result = compare(reference, still, window, of);
    EXPECT_TRUE(result.reference_is_constant);
    EXPECT_NEAR(result.candidate_wave.mean - result.reference_wave.mean, -0.35, 1e-3);
    EXPECT_NEAR(result.maximum_residual, 0.35 + 0.011, 1e-3);
    EXPECT_TRUE(result.modes.empty());
    EXPECT_TRUE(std::isnan(result.normalised_rms.value));
  }
  auto spoilt = reference;
  spoilt.value[1000] = std::nan("");
  EXPECT_TRUE(holds(error_of(spoilt, still), "not finite"));
  EXPECT_NE(error_of(sampled(wave, 0, 12), still), "");
  EXPECT_EQ(compare(still, still, window, modes).maximum_residual, 0);
}

TEST(Comparison, SeesWhatTheCandidateShowsBetweenTheSamplesOfAReferenceThatIsResolved) {
  const auto smooth = [](double t) { return std::sin(forced * t); };
  auto candidate = sampled(smooth, 0, 20);
  candidate.value[1003] += 0.04;
  const auto result = compare(candidate, sampled(smooth, 0, 20, 0.1), window, {});
  EXPECT_FALSE(result.unseen);
  EXPECT_NEAR(result.maximum_residual, 0.04, 1e-3);
}

// The sums themselves, in place of Fourier transforms and running sums.
double lag_by_sums(const TimeSeries& c, const TimeSeries& r, int most) {
  double best = -2;
  int at = 0;
  const int count = static_cast<int>(r.value.size());
  for (int lag = -most; lag <= most; ++lag) {
    double cc = 0, rr = 0, cr = 0;
    for (int i = std::max(0, -lag); i < std::min(count, count - lag); ++i) {
      const double x = c.value[static_cast<std::size_t>(i + lag)],
                   y = r.value[static_cast<std::size_t>(i)];
      cc += x * x;
      rr += y * y;
      cr += x * y;
    }
    if (cr / std::sqrt(cc * rr) > best) {
      best = cr / std::sqrt(cc * rr);
      at = lag;
    }
  }
  return 0.01 * at;
}

// A pressure that is cut off at 0 falls dry only where the other's comes near to 0 too.
TEST(Comparison, DoubtsAPressureThatReadsZeroWhereTheOtherStaysFarFromIt) {
  const auto doubts_of = [](double mean) {
    const auto series = [&](double amplitude, double middle) {
      TimeSeries one = sampled(
          [&](double t) { return std::max(0.0, middle + amplitude * std::sin(3 * t)); }, 0, 20);
      one.name = "wall_pressure@P";
      one.unit = "Pa";
      return one;
    };
    const std::vector<ToneRequest> modes{{"forced", 3.0, false}};
    return compare({"candidate", series(144, 50), {0, 20}, modes},
                   {"reference", series(100, mean), {0, 20}, modes})
        .doubts;
  };
  EXPECT_EQ(doubts_of(1962).size(), 1U);
  EXPECT_TRUE(doubts_of(50).empty());
}

TEST(CrossCorrelation, IsThatOfTheSumsUnderNoise) {
  const auto r = with_noise(sampled([](double t) { return std::sin(5 * t); }, 0, 20), 0.4, 0.7, 1);
  const auto c =
      with_noise(sampled([](double t) { return std::sin(5 * t - 1.2); }, 0, 20), 0.4, 0.7, 2);
  EXPECT_NEAR(cross_correlation_lag(c, r, window, two_pi / 5), lag_by_sums(c, r, 62), 0.0101);
}

// A quadratic search takes sixteen times as long for four times the samples.
TEST(CrossCorrelation, TakesHardlyLongerThanItsSamplesAreMore) {
  const auto seconds = [](int samples) {
    const auto r = sampled([](double t) { return std::sin(5 * t); }, 0, 20, 20.0 / samples);
    const auto c = sampled([](double t) { return std::sin(5 * t - 0.1); }, 0, 20, 20.0 / samples);
    const std::clock_t begin = std::clock();
    cross_correlation_lag(c, r, window, two_pi / 5);
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  };
  EXPECT_LT(seconds(160000), 10 * std::max(0.01, seconds(40000)));
}

TEST(CrossCorrelation, FindsALagBelowTheSampleInterval) {
  const auto r = sampled([](double t) { return std::sin(5 * t); }, 0, 20);
  const auto c = sampled([](double t) { return 3 * std::sin(5 * (t - 0.1234)) + 7; }, 0, 20);
  EXPECT_NEAR(cross_correlation_lag(c, r, window, two_pi / 5), 0.1234, 5e-4);
  EXPECT_NEAR(cross_correlation_lag(r, c, window, two_pi / 5), -0.1234, 5e-4);
  EXPECT_EQ(cross_correlation_lag(reference, reference, window, forced_period), 0);
  EXPECT_THROW(cross_correlation_lag(c, r, {0, 1}, two_pi / 5), ComparisonError);
}

TEST(ComparisonWithoutModes, IsOfTheWholeHistoriesAlone) {
  const TimeSeries ramp = sampled([](double t) { return 2 * t; }, 0, 1),
                   ahead = sampled([](double t) { return 2 * t + 0.1; }, 0, 1);
  const Comparison result = compare(ahead, ramp, {0, 1}, {});
  EXPECT_NEAR(result.maximum_residual, 0.1, 1e-12);
  EXPECT_NEAR(result.normalised_rms.value, 0.1 * std::sqrt(12.0) / 2,
              1e-3);  // a ramp's rms: 2 / sqrt(12)
  EXPECT_TRUE(result.modes.empty());
  EXPECT_TRUE(result.candidate_peaks.empty());
  EXPECT_TRUE(std::isnan(result.cross_correlation_lag));
}

}  // namespace
}  // namespace slosh::comparison_test
