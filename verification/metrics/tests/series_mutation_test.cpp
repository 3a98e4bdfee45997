#include "verification/metrics/series_mutation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <tuple>

#include "verification/metrics/comparison.hpp"
#include "verification/tests/synthetic_series.hpp"

namespace slosh::series_mutation_test {
namespace {

constexpr double period = 2;    // [s]
constexpr double depth = 0.35;  // [m]
const MutationFrame frame{{4, 16}, period, depth, {{"natural_1", two_pi / period, true}}};

double wave(double t) { return 0.02 * std::sin(two_pi / period * t + 0.3); }
const TimeSeries series = sampled(wave, 0, 20);

TimeSeries with(MutationKind kind, double strength) {
  return mutated(series, {kind, strength}, frame);
}

// The largest difference from a signal within the window.
double departure(const TimeSeries& mutant, const std::function<double(double)>& signal) {
  double largest = 0;
  for (std::size_t i = 0; i < mutant.time.size(); ++i)
    if (mutant.time[i] >= frame.window.begin && mutant.time[i] <= frame.window.end)
      largest = std::max(largest, std::abs(mutant.value[i] - signal(mutant.time[i])));
  return largest;
}

constexpr double interpolated = 0.02 * 2e-4;  // at 200 samples a period

TEST(SeriesMutation, ScalesTheValuesAlone) {
  for (const auto& [kind, strength, factor] : {std::tuple{MutationKind::louder, 0.05, 1.05},
                                               {MutationKind::quieter, 0.2, 0.8},
                                               {MutationKind::thousandfold, 1.0, 1000.0},
                                               {MutationKind::sign_flipped, 1.0, -1.0}}) {
    const TimeSeries mutant = with(kind, strength);
    EXPECT_EQ(mutant.time, series.time);
    EXPECT_EQ(mutant.unit, series.unit);
    for (std::size_t i = 0; i < series.value.size(); i += 100)
      EXPECT_DOUBLE_EQ(mutant.value[i], factor * series.value[i]);
  }
}

TEST(SeriesMutation, ShiftsByAPartOfThePeriodAndHoldsTheEnds) {
  const TimeSeries late = with(MutationKind::late, 0.05), early = with(MutationKind::early, 0.05);
  EXPECT_EQ(late.time, series.time);
  EXPECT_LT(departure(late, [](double t) { return wave(t - 0.1); }), interpolated);
  EXPECT_LT(departure(early, [](double t) { return wave(t + 0.1); }), interpolated);
  EXPECT_DOUBLE_EQ(late.value[3], series.value.front());
  EXPECT_DOUBLE_EQ(early.value[1997], series.value.back());
}

TEST(SeriesMutation, SlipsByAWholePeriodThatNoPhaseCanTell) {
  const TimeSeries slipped = with(MutationKind::slipped, 1);
  EXPECT_LT(departure(slipped, wave), interpolated);
  EXPECT_DOUBLE_EQ(slipped.value[150], series.value.front());
}

TEST(SeriesMutation, ChangesTheFrequency) {
  const std::vector<ToneRequest> mode{{"natural_1", two_pi / period, true}};
  for (const double strength : {0.001, 0.02}) {
    const auto fast = compare(with(MutationKind::faster, strength), series, frame.window, mode);
    const auto slow = compare(with(MutationKind::slower, strength), series, frame.window, mode);
    EXPECT_NEAR(fast.modes[0].frequency_error.value, strength, 1e-6);
    EXPECT_NEAR(slow.modes[0].frequency_error.value, -strength, 1e-6);
  }
}

TEST(SeriesMutation, MovesTheDatum) {
  const TimeSeries raised = with(MutationKind::raised, 0.02),
                   lowered = with(MutationKind::lowered, 0.02);
  EXPECT_LT(departure(raised, [](double t) { return wave(t) + 0.007; }), 1e-12);
  EXPECT_LT(departure(lowered, [](double t) { return wave(t) - 0.007; }), 1e-12);
}

TEST(SeriesMutation, DriftsOverTheWindow) {
  const double deviation = 0.02 / std::sqrt(2);
  const TimeSeries drifting = with(MutationKind::drifting, 0.5);
  EXPECT_LT(departure(drifting, [&](double t) { return wave(t) + 0.5 * deviation * (t - 4) / 12; }),
            1e-5);
  EXPECT_DOUBLE_EQ(drifting.value.front(), series.value.front());
}

TEST(SeriesMutation, ChangesTheFrequencySlowly) {
  const TimeSeries chirped = with(MutationKind::chirped, 0.1);
  EXPECT_LT(departure(chirped,
                      [](double t) { return wave(t + 0.1 * period * std::pow((t - 4) / 12, 2)); }),
            interpolated);
}

// A frame of two modes, fitted to the series.
MutationFrame two_modes_of(const TimeSeries& fitted) {
  MutationFrame two_modes = frame;
  two_modes.modes.push_back({"natural_2", two_pi / 0.7, true});
  two_modes.tones = fit_harmonics(fitted, two_modes.window, two_modes.modes).tones;
  return two_modes;
}

TEST(SeriesMutation, DampsTheFittedPartOfOneModeAloneFromTheWindowsBeginOn) {
  const auto other = [](double t, double rate) {
    return 0.005 * std::exp(-rate * std::max(0.0, t - 4)) * std::cos(two_pi / 0.7 * t);
  };
  const TimeSeries both = sampled([&](double t) { return wave(t) + other(t, 0.1); }, 0, 20);
  const TimeSeries damped =
      mutated(both, {MutationKind::mode_damped, 1, "natural_2"}, two_modes_of(both));
  EXPECT_LT(departure(damped, [&](double t) { return wave(t) + other(t, 0.2); }), 1e-5);
}

TEST(SeriesMutation, GainsTheFittedPartOfOneModeAlone) {
  const auto other = [](double t) { return 0.005 * std::cos(two_pi / 0.7 * t); };
  const TimeSeries both = sampled([&](double t) { return wave(t) + other(t); }, 0, 20);
  const MutationFrame two_modes = two_modes_of(both);
  const TimeSeries gained = mutated(both, {MutationKind::mode_gained, 0.2, "natural_2"}, two_modes);
  EXPECT_LT(departure(gained, [&](double t) { return wave(t) + 1.2 * other(t); }), 1e-5);
  EXPECT_THROW(mutated(both, {MutationKind::mode_gained, 0.2, "natural_3"}, two_modes),
               ComparisonError);
}

TEST(SeriesMutation, AddsNoiseOfTheStatedSizeTheSameEachTime) {
  const TimeSeries noisy = with(MutationKind::noisy, 0.1);
  double squares = 0;
  for (std::size_t i = 0; i < series.value.size(); ++i)
    squares += std::pow(noisy.value[i] - series.value[i], 2);
  const double deviation = std::sqrt(squares / static_cast<double>(series.value.size()));
  EXPECT_NEAR(deviation, 0.1 * 0.02 / std::sqrt(2), 5e-5);
  EXPECT_EQ(noisy.value, with(MutationKind::noisy, 0.1).value);
}

TEST(SeriesMutation, EndsWithinTheWindow) {
  const TimeSeries truncated = with(MutationKind::truncated, 0.25);
  EXPECT_NEAR(truncated.time.back(), 13, 0.011);
  EXPECT_EQ(truncated.time.size(), truncated.value.size());
  EXPECT_THROW(compare(truncated, series, frame.window, {}), ComparisonError);
}

TEST(SeriesMutation, PoisonsOneSampleInTheWindow) {
  const TimeSeries poisoned = with(MutationKind::not_a_number, 1);
  int poison = 0;
  for (std::size_t i = 0; i < poisoned.value.size(); ++i) {
    if (!std::isnan(poisoned.value[i])) continue;
    ++poison;
    EXPECT_NEAR(poisoned.time[i], 10, 0.011);
  }
  EXPECT_EQ(poison, 1);
  EXPECT_THROW(compare(poisoned, series, frame.window, {}), ComparisonError);
}

TEST(SeriesMutation, SwapsTheColumns) {
  const TimeSeries swapped = with(MutationKind::swapped_columns, 1);
  EXPECT_EQ(swapped.time, series.value);
  EXPECT_EQ(swapped.value, series.time);
  EXPECT_THROW(compare(swapped, series, frame.window, {}), ComparisonError);
}

TEST(SeriesMutation, LabelsAnotherUnit) {
  const TimeSeries other = with(MutationKind::other_unit, 1);
  EXPECT_EQ(other.unit, "mm");
  EXPECT_EQ(other.value, series.value);
  EXPECT_THROW(compare(other, series, frame.window, {}), ComparisonError);
}

TEST(SeriesMutation, RefusesASeriesThatIsNotSoundToBeginWith) {
  TimeSeries poisoned = series;
  poisoned.value[1000] = std::nan("");
  EXPECT_THROW(mutated(poisoned, {MutationKind::louder, 0.1}, frame), ComparisonError);
  EXPECT_THROW(mutated(sampled(wave, 0, 10), {MutationKind::louder, 0.1}, frame), ComparisonError);
}

TEST(SeriesMutation, HasANameForEachKind) {
  EXPECT_EQ(mutation_name(MutationKind::louder), "louder");
  EXPECT_EQ(mutation_name(MutationKind::not_a_number), "not a number");
  EXPECT_EQ(mutation_name(MutationKind::sign_flipped), "sign flipped");
}

}  // namespace
}  // namespace slosh::series_mutation_test
