// What gate rows on pressure fields detect, judged with all their evidence.
#include "verification/sensitivity/field_trials.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "verification/case/field_times.hpp"
#include "verification/sensitivity/gate_sensitivity.hpp"
#include "verification/tests/field_results.hpp"
#include "verification/tests/surge_results.hpp"

namespace slosh::field_trials_test {
namespace {

// A slope along the tank as well, so that a moved field differs.
double pressure_at(double x, double z) { return 9810 * (0.35 - z) + 2000 * x; }

GateRow field_row(Metric metric, const std::string& mode, double limit) {
  GateRow row = surge_row(mode, metric, "1", limit);
  row.reference = "fine_mesh";
  row.quantity = pressure_field;
  row.kind = RowKind::regression;
  return row;
}

CaseAssessment assessed(const std::vector<GateRow>& gate) {
  CaseDefinition definition = surge_case();
  definition.snapshot_times = {2, 4, 6, 8};
  definition.gate = gate;
  CaseRuns runs = surge_runs();
  for (const double time : definition.snapshot_times) {
    runs.results.at("fine_mesh").snapshots.push_back(tiled_field(time, {0.02, 0.01}, pressure_at));
    runs.results.at("particles")
        .snapshots.push_back(tiled_field(time, {0.005, 0.005}, pressure_at));
  }
  return assess(definition, runs);
}

MutationTrials trials_of(const GateRow& row) {
  const auto sensitivity = gate_sensitivity(assessed({row}));
  return sensitivity.at(0).trials;
}

std::optional<double> strength(const MutationTrials& trials, MutationKind kind) {
  return detected_from(trials, kind);
}

TEST(FieldTrials, FindTheSmallestChangeOfTheFieldThatARowDetects) {
  const MutationTrials trials = trials_of(field_row(Metric::pressure_field_rms, "whole", 0.045));
  ASSERT_TRUE(trials.passes_as_it_is);
  EXPECT_EQ(strength(trials, MutationKind::raised), 0.05);
  EXPECT_EQ(strength(trials, MutationKind::lowered), 0.05);
  EXPECT_EQ(strength(trials, MutationKind::louder), 0.1);  // the rms is some 0.8 of the datum
  EXPECT_EQ(strength(trials, MutationKind::late), 0.1);    // 200 Pa
  EXPECT_EQ(strength(trials, MutationKind::noisy), 0.5);   // a cell is the mean of 8 particles
  for (const MutationKind kind : {MutationKind::truncated, MutationKind::not_a_number,
                                  MutationKind::thousandfold, MutationKind::sign_flipped})
    EXPECT_TRUE(strength(trials, kind).has_value()) << mutation_name(kind);
  EXPECT_FALSE(was_tried(trials, MutationKind::drifting));
  EXPECT_TRUE(broken_claims(trials).empty());
  EXPECT_FALSE(detects_no_change(trials));
}

TEST(FieldTrials, ClaimWhatTheTriangleInequalityTells) {
  const MutationTrials trials = trials_of(field_row(Metric::pressure_field_rms, "whole", 0.045));
  const auto claimed = [&](MutationKind kind, double s) {
    return std::any_of(trials.outcomes.begin(), trials.outcomes.end(), [&](const auto& one) {
      return one.mutation.kind == kind && one.mutation.strength == s && one.claimed;
    });
  };
  EXPECT_TRUE(claimed(MutationKind::raised, 0.05));
  EXPECT_FALSE(claimed(MutationKind::raised, 0.02));
  EXPECT_TRUE(claimed(MutationKind::quieter, 0.1));
  EXPECT_FALSE(claimed(MutationKind::quieter, 0.05));
  EXPECT_TRUE(claimed(MutationKind::sign_flipped, 1));
  EXPECT_TRUE(claimed(MutationKind::truncated, 0.2));
  EXPECT_TRUE(claimed(MutationKind::not_a_number, 1));
  EXPECT_FALSE(claimed(MutationKind::late, 0.1));
}

TEST(FieldTrials, ClaimTheLossOfAMomentOnlyOfRowsThatJudgeIt) {
  for (const auto& [mode, judges] : {std::pair{"moment_1", false}, {"moment_4", true}}) {
    const MutationTrials trials = trials_of(field_row(Metric::pressure_field_rms, mode, 0.045));
    EXPECT_EQ(detected_from(trials, MutationKind::truncated).has_value(), judges) << mode;
    EXPECT_TRUE(broken_claims(trials).empty()) << mode;
  }
}

TEST(FieldTrials, ShowThatARowOnTensionDetectsAFieldBelowTheGases) {
  const MutationTrials trials = trials_of(field_row(Metric::pressure_field_tension, "whole", 0.05));
  ASSERT_TRUE(trials.passes_as_it_is);
  EXPECT_TRUE(strength(trials, MutationKind::sign_flipped).has_value());
  EXPECT_FALSE(strength(trials, MutationKind::louder).has_value());
  EXPECT_TRUE(broken_claims(trials).empty());
  EXPECT_FALSE(detects_no_change(trials));
}

TEST(FieldTrials, FindOutARowThatJudgesNothing) {
  EXPECT_TRUE(detects_no_change(trials_of(field_row(Metric::pressure_field_rms, "whole", 1e6))));
}

TEST(FieldTrials, CountAmongWhatTheRowsOfACaseDetect) {
  const auto sensitivity =
      gate_sensitivity(assessed({field_row(Metric::pressure_field_rms, "whole", 0.045),
                                 surge_row("forced", Metric::amplitude_error, "1", 0.04)}));
  ASSERT_EQ(sensitivity.size(), 2u);
  EXPECT_EQ(sensitivity[0].row.quantity, pressure_field);
  EXPECT_TRUE(detects(sensitivity[0].trials, {MutationKind::louder, 0.1}));
  EXPECT_TRUE(detects(sensitivity[1].trials, {MutationKind::louder, 0.1}));
}

TEST(FieldTrials, SayOnlyThatARowDoesNotPassAsItIs) {
  CaseAssessment assessment = assessed({});
  CaseDefinition definition = assessment.definition;
  definition.gate = {field_row(Metric::pressure_field_rms, "whole", 0.045)};
  for (FieldSnapshot& field : assessment.runs.results.at("particles").snapshots)
    for (double& pressure : field.pressure) pressure += 400;
  const auto sensitivity = gate_sensitivity(assess(definition, assessment.runs));
  EXPECT_FALSE(sensitivity.at(0).trials.passes_as_it_is);
  EXPECT_TRUE(sensitivity.at(0).trials.outcomes.empty());
}

}  // namespace
}  // namespace slosh::field_trials_test
