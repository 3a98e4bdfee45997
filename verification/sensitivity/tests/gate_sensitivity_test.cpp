// The sensitivity of a case's rows, which are judged with all their evidence.
#include "verification/sensitivity/gate_sensitivity.hpp"

#include <gtest/gtest.h>

#include <future>

#include "verification/tests/surge_results.hpp"

namespace slosh::gate_sensitivity_test {
namespace {

CaseAssessment surge_with(const std::vector<GateRow>& gate) {
  CaseDefinition definition = surge_case();
  definition.gate = gate;
  return assess(definition, surge_runs());
}

TEST(GateSensitivity, FindsTheSmallestChangeThatARowDetects) {
  const CaseAssessment assessment =
      surge_with({surge_row("forced", Metric::amplitude_error, "1", 0.04)});
  const auto sensitivity = gate_sensitivity(assessment);
  ASSERT_EQ(sensitivity.size(), 1U);
  ASSERT_TRUE(sensitivity[0].trials.passes_as_it_is);
  EXPECT_EQ(detected_from(sensitivity[0].trials, MutationKind::louder), 0.05);
  EXPECT_TRUE(detected_from(sensitivity[0].trials, MutationKind::not_a_number).has_value());
  EXPECT_TRUE(broken_claims(sensitivity).empty());
}

TEST(GateSensitivity, IsTheSameOnSeveralThreads) {
  const CaseAssessment assessment =
      surge_with({surge_row("forced", Metric::amplitude_error, "1", 0.04),
                  surge_row("natural_1", Metric::frequency_error, "1", 0.015)});
  const auto alone = gate_sensitivity(assessment);
  const auto together = gate_sensitivity(
      assessment, nullptr, [](std::size_t count, const std::function<void(std::size_t)>& work) {
        std::vector<std::future<void>> threads;
        for (std::size_t i = 0; i < count; ++i)
          threads.push_back(std::async(std::launch::async, work, i));
        for (std::future<void>& thread : threads) thread.get();
      });
  ASSERT_EQ(together.size(), alone.size());
  for (std::size_t i = 0; i < alone.size(); ++i) {
    ASSERT_EQ(together[i].trials.outcomes.size(), alone[i].trials.outcomes.size());
    for (std::size_t k = 0; k < alone[i].trials.outcomes.size(); ++k)
      EXPECT_EQ(together[i].trials.outcomes[k].detected, alone[i].trials.outcomes[k].detected);
  }
}

TEST(GateSensitivity, ShowsAWideLimitByWhatItLetsPass) {
  const auto sensitivity =
      gate_sensitivity(surge_with({surge_row("forced", Metric::amplitude_error, "1", 0.5)}));
  EXPECT_FALSE(detected_from(sensitivity.at(0).trials, MutationKind::louder).has_value());
}

TEST(GateSensitivity, SaysOnlyThatARowDoesNotPassAsItIs) {
  TimeSeries high = elevation_of({});
  for (double& value : high.value) value *= 1.2;
  CaseDefinition definition = surge_case();
  definition.gate = {surge_row("forced", Metric::amplitude_error, "1", 0.05)};
  const CaseAssessment assessment = assess(definition, surge_runs_with("particles", high));
  const auto sensitivity = gate_sensitivity(assessment);
  EXPECT_FALSE(sensitivity.at(0).trials.passes_as_it_is);
  EXPECT_TRUE(sensitivity.at(0).trials.outcomes.empty());
}

TEST(GateSensitivity, FindsOutARowThatJudgesNothing) {
  const auto sensitivity =
      gate_sensitivity(surge_with({surge_row("forced", Metric::amplitude_error, "1", 1e300),
                                   surge_row("forced", Metric::phase_lag, "deg", 5)}));
  EXPECT_EQ(
      broken_claims(sensitivity),
      std::vector<std::string>{"particles, forced amplitude_error of elevation@right: detects "
                               "no change of its candidate's values"});
}

TEST(GateSensitivity, MeasuresTheDatumByTheFillDepthAndItsPressure) {
  const CaseDefinition definition = surge_case();
  EXPECT_DOUBLE_EQ(datum_of(definition, "elevation@right"), 0.35);
  EXPECT_DOUBLE_EQ(datum_of(definition, "wall_pressure@side"), 1000 * 9.81 * 0.35);
  EXPECT_DOUBLE_EQ(datum_of(definition, "wall_pressure@side/filtered"), 1000 * 9.81 * 0.35);
  EXPECT_EQ(datum_of(definition, "force_x"), 0);
}

TEST(GateSensitivity, FindsOutARowThatLetsPassWhatItMustDetect) {
  RowSensitivity blind{surge_row("forced", Metric::amplitude_error, "1", 0.05),
                       {true,
                        {{{MutationKind::louder, 0.2}, true, false},
                         {{MutationKind::quieter, 0.2}, true, true},
                         {{MutationKind::mode_gained, 0.1, "natural_1"}, true, false},
                         {{MutationKind::mode_damped, 0.5, "natural_1"}, true, false}}}};
  const std::string row = "particles, forced amplitude_error of elevation@right: ";
  EXPECT_EQ(broken_claims({blind}),
            (std::vector<std::string>{row + "louder 0.2 should be detected and is not",
                                      row + "natural_1 gained 0.1 should be detected and is not",
                                      row + "natural_1 damped 0.5 should be detected and is not"}));
}

// The surge's particles in a band of a record that is theory itself, 1 mm to either side.
CaseAssessment surge_in_a_band() {
  const TimeSeries theory = elevation_of({});
  RecordRun record{"record.csv", surge_quantity, "m", theory.time, theory.value, {}};
  record.has_band = true;
  CaseRuns runs = surge_runs();
  TimeSeries lower = theory, upper = theory;
  lower.name += "/lower";
  upper.name += "/upper";
  for (double& value : lower.value) value -= 0.001;
  for (double& value : upper.value) value += 0.001;
  record.lower = lower.value;
  record.upper = upper.value;
  runs.results["measured"] = result_of("measured", theory);
  runs.results["measured"].series.insert(runs.results["measured"].series.end(), {lower, upper});
  runs.status["measured"] = {RunState::finished, ""};
  CaseDefinition definition = surge_case();
  definition.runs.push_back(sample_run(record));
  definition.runs.back().name = "measured";
  definition.gate = {surge_row("whole", Metric::outside_band, "1", 0.1)};
  for (GateRow& row : definition.gate) {
    row.reference = "measured";
    row.kind = RowKind::regression;
  }
  return assess(definition, runs);
}

TEST(GateSensitivity, OfABandFindsWhatLeavesIt) {
  const auto sensitivity = gate_sensitivity(surge_in_a_band());
  ASSERT_EQ(sensitivity.size(), 1U);
  for (const RowSensitivity& one : sensitivity) {
    ASSERT_TRUE(one.trials.passes_as_it_is);
    for (const MutationKind kind :
         {MutationKind::louder, MutationKind::quieter, MutationKind::late, MutationKind::raised,
          MutationKind::lowered, MutationKind::truncated, MutationKind::not_a_number})
      EXPECT_TRUE(detected_from(one.trials, kind).has_value())
          << short_row_name(one.row) << ", kind " << static_cast<int>(kind);
  }
  EXPECT_TRUE(broken_claims(sensitivity).empty());
}

}  // namespace
}  // namespace slosh::gate_sensitivity_test
