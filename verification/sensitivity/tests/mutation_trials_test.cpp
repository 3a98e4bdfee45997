#include "verification/sensitivity/mutation_trials.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "verification/gate/gate.hpp"
#include "verification/tests/synthetic_series.hpp"

namespace slosh::mutation_trials_test {
namespace {

constexpr double forced = 3, natural = 4.96646;  // [rad/s]
constexpr TimeWindow window{5, 25};
const std::vector<ToneRequest> modes{{"forced", forced, false}, {"natural_1", natural, true}};

// The candidate is 1 % high, 1.7 degrees late in the forced mode, and a little noisy.
const TimeSeries reference = sampled(
    [](double t) { return 0.01 * std::sin(forced * t) + 0.006 * std::sin(natural * t); }, 0, 26);
const TimeSeries candidate = with_noise(
    sampled(
        [](double t) {
          return 1.01 * (0.01 * std::sin(forced * (t - 0.01)) + 0.006 * std::sin(natural * t));
        },
        0, 26),
    5e-5, 0.5, 3);

GateRow row_of(Metric metric, const std::string& mode, const std::string& unit, double limit) {
  GateRow row{};
  row.candidate = "sph";
  row.reference = "linear";
  row.quantity = reference.name;
  row.metric = metric;
  row.mode = mode;
  row.unit = unit;
  row.limit = limit;
  return row;
}

const PreparedSeries prepared("reference", reference, window, modes);

// As the gate judges a campaign's rows.
GateOutcome judge(const GateRow& row, const FindComparison& comparison) {
  return evaluate(row, {{"sph", {RunState::finished, ""}}, {"linear", {RunState::finished, ""}}},
                  {comparison, {}});
}

Comparison comparison_of(const TimeSeries& series) {
  return compare({"candidate", series, window, modes}, prepared);
}

constexpr double depth = 0.35;  // [m]

MutationFrame frame_of(const GateRow& row) {
  static const std::vector<Tone> tones = fit_harmonics(candidate, window, modes).tones;
  return {window, two_pi / (row.mode == "natural_1" ? natural : forced), depth, modes, tones};
}

TimeSeries candidate_with(const Mutation* mutation, const MutationFrame& frame) {
  return mutation ? mutated(candidate, *mutation, frame) : candidate;
}

// Each mutant is compared once for all tests of this program, as the fits take most of their time.
GateOutcome judge(const GateRow& row, const Mutation* mutation) {
  using Mutant = std::tuple<double, std::optional<MutationKind>, double, std::string>;
  static std::map<Mutant, Comparison> known;
  return judge(row, [&](const auto&, const auto&, const auto&) -> const Comparison& {
    const MutationFrame frame = frame_of(row);
    const Mutant mutant =
        mutation ? Mutant{frame.period, mutation->kind, mutation->strength, mutation->mode}
                 : Mutant{};
    const auto found = known.find(mutant);
    if (found != known.end()) return found->second;
    return known[mutant] = comparison_of(candidate_with(mutation, frame));
  });
}

double measured(const GateRow& row) { return judge(row, nullptr).value.value; }

MutationTrials trials_of(const GateRow& row) {
  return try_mutations({{row, measured(row)}}, candidate, frame_of(row),
                       [&](const Mutation* mutation) {
                         return std::vector<Verdict>{judge(row, mutation).verdict};
                       })
      .at(0);
}

bool detects(const MutationTrials& trials, MutationKind kind) {
  return detected_from(trials, kind).has_value();
}

void expect_to_detect_what_is_unsound(const MutationTrials& trials) {
  for (const MutationKind kind : {MutationKind::truncated, MutationKind::not_a_number,
                                  MutationKind::swapped_columns, MutationKind::other_unit})
    EXPECT_TRUE(detects(trials, kind)) << mutation_name(kind);
}

const GateRow amplitude = row_of(Metric::amplitude_error, "forced", "1", 0.025);
const GateRow lag = row_of(Metric::phase_lag, "forced", "deg", 4);
const GateRow frequency = row_of(Metric::frequency_error, "natural_1", "1", 0.004);
const GateRow rms = row_of(Metric::normalised_rms, "whole", "1", 0.06);

TEST(MutationTrials, OfANarrowAmplitudeRowBeginsAtItsLimit) {
  const MutationTrials trials = trials_of(amplitude);
  ASSERT_TRUE(trials.passes_as_it_is);
  EXPECT_EQ(detected_from(trials, MutationKind::louder), 0.02);
  EXPECT_EQ(detected_from(trials, MutationKind::quieter), 0.05);
  EXPECT_TRUE(detects(trials, MutationKind::thousandfold));
  expect_to_detect_what_is_unsound(trials);
  EXPECT_TRUE(broken_claims(trials).empty());
}

TEST(MutationTrials, OfALagRowIsInShiftsAndTheSign) {
  const MutationTrials trials = trials_of(lag);
  ASSERT_TRUE(trials.passes_as_it_is);
  EXPECT_EQ(detected_from(trials, MutationKind::late), 0.01);   // 1.7 and 3.6 degrees
  EXPECT_EQ(detected_from(trials, MutationKind::early), 0.02);  // 1.7 less 7.2 degrees
  EXPECT_TRUE(detects(trials, MutationKind::sign_flipped));
  EXPECT_FALSE(detects(trials, MutationKind::louder));
  EXPECT_FALSE(detects(trials, MutationKind::thousandfold));
  expect_to_detect_what_is_unsound(trials);
  EXPECT_TRUE(broken_claims(trials).empty());
}

TEST(MutationTrials, OfAFrequencyRowIsInStretches) {
  const MutationTrials trials = trials_of(frequency);
  ASSERT_TRUE(trials.passes_as_it_is);
  EXPECT_EQ(detected_from(trials, MutationKind::faster), 0.005);
  EXPECT_EQ(detected_from(trials, MutationKind::slower), 0.005);
  EXPECT_FALSE(detects(trials, MutationKind::quieter));
  expect_to_detect_what_is_unsound(trials);
  EXPECT_TRUE(broken_claims(trials).empty());
}

TEST(MutationTrials, OfAResidualRowIsInAllOfThem) {
  const MutationTrials trials = trials_of(rms);
  ASSERT_TRUE(trials.passes_as_it_is);
  for (const MutationKind kind :
       {MutationKind::louder, MutationKind::quieter, MutationKind::late, MutationKind::early,
        MutationKind::faster, MutationKind::slower, MutationKind::raised, MutationKind::lowered,
        MutationKind::drifting, MutationKind::chirped, MutationKind::mode_gained,
        MutationKind::noisy, MutationKind::slipped, MutationKind::thousandfold,
        MutationKind::sign_flipped})
    EXPECT_TRUE(detects(trials, kind)) << mutation_name(kind);
  expect_to_detect_what_is_unsound(trials);
  EXPECT_TRUE(broken_claims(trials).empty());
}

TEST(MutationTrials, ShowsTheWeaknessOfAWideLimit) {
  const MutationTrials trials = trials_of(row_of(Metric::amplitude_error, "forced", "1", 0.5));
  ASSERT_TRUE(trials.passes_as_it_is);
  EXPECT_FALSE(detects(trials, MutationKind::louder));
  EXPECT_FALSE(detects(trials, MutationKind::quieter));
  expect_to_detect_what_is_unsound(trials);
  EXPECT_TRUE(broken_claims(trials).empty());  // it claims no more than it can
}

TEST(MutationTrials, FindsOutAJudgeThatAlwaysPasses) {
  const MutationTrials trials =
      try_mutations({{amplitude, 0.01}}, candidate, frame_of(amplitude), [](const auto&) {
        return std::vector<Verdict>{Verdict::pass};
      }).at(0);
  EXPECT_TRUE(detects_no_change(trials));
  for (const MutationOutcome& outcome : trials.outcomes) EXPECT_FALSE(outcome.detected);
  const std::vector<Mutation> broken = broken_claims(trials);
  for (const MutationKind kind : {MutationKind::louder, MutationKind::truncated,
                                  MutationKind::not_a_number, MutationKind::swapped_columns})
    EXPECT_TRUE(std::any_of(broken.begin(), broken.end(),
                            [kind](const Mutation& one) { return one.kind == kind; }));
}

TEST(MutationTrials, FindsOutAJudgeThatIgnoresNaN) {
  const auto careless = [](const Mutation* mutation) {
    TimeSeries cleaned = candidate_with(mutation, frame_of(amplitude));
    for (double& value : cleaned.value)
      if (std::isnan(value)) value = 0;
    Comparison comparison;
    const auto compared = [&](const auto&, const auto&, const auto&) -> const Comparison& {
      return comparison = comparison_of(cleaned);
    };
    return std::vector<Verdict>{judge(amplitude, compared).verdict};
  };
  const auto broken = broken_claims(
      try_mutations({{amplitude, 0.01}}, candidate, frame_of(amplitude), careless).at(0));
  ASSERT_EQ(broken.size(), 1U);
  EXPECT_EQ(broken[0].kind, MutationKind::not_a_number);
}

TEST(MutationTrials, OfARowThatAnythingPassesIsNone) {
  const MutationTrials trials = trials_of(row_of(Metric::amplitude_error, "forced", "1", 1e300));
  ASSERT_TRUE(trials.passes_as_it_is);
  expect_to_detect_what_is_unsound(trials);
  EXPECT_TRUE(detects_no_change(trials));
  EXPECT_FALSE(detects_no_change(trials_of(amplitude)));
}

TEST(MutationTrials, OfACostIsToldByRunsThatTheFormLeavesOut) {
  const auto tried_with = [](const GateRow& row) {
    return try_mutations(
               {{row, 10}}, candidate, frame_of(row),
               [](const Mutation* mutation) {
                 return std::vector<Verdict>{mutation ? Verdict::not_selected : Verdict::pass};
               })
        .at(0);
  };
  EXPECT_FALSE(detects_no_change(tried_with(row_of(Metric::cost_to_reach, "whole", "s", 60))));
  EXPECT_TRUE(detects_no_change(tried_with(amplitude)));
}

TEST(MutationTrials, OfAnOffsetRowIsInTheDatum) {
  const GateRow offset = row_of(Metric::mean_offset, "whole", "m", 0.003);
  const MutationTrials trials = trials_of(offset);
  ASSERT_TRUE(trials.passes_as_it_is);
  EXPECT_EQ(detected_from(trials, MutationKind::raised), 0.01);  // of 0.35 m: 3.5 mm
  EXPECT_EQ(detected_from(trials, MutationKind::lowered), 0.01);
  EXPECT_TRUE(detects(trials, {MutationKind::raised, 0.02}));
  EXPECT_FALSE(detects(trials, {MutationKind::raised, 0.005}));
  EXPECT_FALSE(detects(trials, MutationKind::louder));
  EXPECT_TRUE(broken_claims(trials).empty());
}

TEST(MutationTrials, OfADriftIsThatOfItsMean) {
  const MutationTrials trials = trials_of(row_of(Metric::mean_offset, "whole", "m", 0.001));
  ASSERT_TRUE(trials.passes_as_it_is);  // the deviation is 8.3 mm
  EXPECT_EQ(detected_from(trials, MutationKind::drifting), 0.5);
  EXPECT_TRUE(broken_claims(trials).empty());
}

TEST(MutationTrials, OfASlowChangeOfFrequencyIsItsMeanLag) {
  const MutationTrials trials = trials_of(lag);
  // 6 degrees less 1.7; a smaller one is told where the fit refuses what lies beside the forcing.
  EXPECT_LE(detected_from(trials, MutationKind::chirped).value(), 0.05);
  EXPECT_TRUE(broken_claims(trials).empty());
}

TEST(MutationTrials, TellsTheGainOfANaturalModeFromThatOfTheForcedOne) {
  const GateRow natural_row = row_of(Metric::amplitude_error, "natural_1", "1", 0.04);
  EXPECT_EQ(detected_from(trials_of(natural_row), MutationKind::mode_gained), 0.05);
  EXPECT_TRUE(broken_claims(trials_of(natural_row)).empty());
  EXPECT_FALSE(detected_from(trials_of(amplitude), MutationKind::mode_gained).has_value());
}

TEST(MutationTrials, JudgesRowsTogetherAsEachAlone) {
  const auto together =
      try_mutations({{amplitude, measured(amplitude)}, {rms, measured(rms)}}, candidate,
                    frame_of(amplitude), [&](const Mutation* mutation) {
                      return std::vector<Verdict>{judge(amplitude, mutation).verdict,
                                                  judge(rms, mutation).verdict};
                    });
  for (const auto& [one, alone] :
       {std::pair{together[0], trials_of(amplitude)}, std::pair{together[1], trials_of(rms)}}) {
    ASSERT_EQ(one.outcomes.size(), alone.outcomes.size());
    for (std::size_t i = 0; i < one.outcomes.size(); ++i) {
      EXPECT_EQ(one.outcomes[i].detected, alone.outcomes[i].detected) << i;
      EXPECT_EQ(one.outcomes[i].claimed, alone.outcomes[i].claimed) << i;
    }
  }
}

TEST(MutationTrials, IsNotAskedOfARowThatDoesNotPassAsItIs) {
  const MutationTrials trials = trials_of(row_of(Metric::amplitude_error, "forced", "1", 0.001));
  EXPECT_FALSE(trials.passes_as_it_is);
  EXPECT_TRUE(trials.outcomes.empty());
  EXPECT_FALSE(detected_from(trials, MutationKind::louder));
}

TEST(MutationTrials, CountsFromWhereNothingStrongerIsMissed) {
  const auto outcome = [](double strength, bool detected) {
    return MutationOutcome{{MutationKind::louder, strength}, true, detected};
  };
  EXPECT_EQ(detected_from({true, {outcome(0.1, true), outcome(0.2, false), outcome(0.3, true)}},
                          MutationKind::louder),
            0.3);
  EXPECT_FALSE(
      detected_from({true, {outcome(0.1, true), outcome(0.2, false)}}, MutationKind::louder));
}

}  // namespace
}  // namespace slosh::mutation_trials_test
