// Gate rows on pressure fields: they hold of a run that has the reference's field and turn red on
// every way in which a field can be wrong.
#include "verification/gate/field_metrics.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "verification/case/field_times.hpp"
#include "verification/gate/gate.hpp"
#include "verification/tests/field_results.hpp"
#include "verification/tests/sample_case.hpp"

namespace slosh::field_metrics_test {
namespace {

CaseDefinition case_with_moments() {
  CaseDefinition definition = sample_case();
  definition.snapshot_times = {0.5, 1, 1.5};
  return definition;
}

const CaseDefinition definition = case_with_moments();
const double scale = 1000 * 9.81 * 0.35;  // [Pa]

double at_rest(double, double z) { return 9810 * (0.35 - z); }

RunResult run_of(const std::string& name, const Tiles& tiles, const PressureAt& pressure) {
  RunResult result;
  result.run_name = name;
  for (const double time : definition.snapshot_times)
    result.snapshots.push_back(tiled_field(time, tiles, pressure));
  return result;
}

const RunResult reference = run_of("mesh", {.width = 0.02, .height = 0.01}, at_rest);
const Tiles particles{.width = 0.005, .height = 0.005};

RunResult particles_with(const PressureAt& pressure) {
  return run_of("particles", particles, pressure);
}

GateRow row_of(Metric metric, const std::string& mode) {
  GateRow row{};
  row.candidate = "particles";
  row.reference = "mesh";
  row.quantity = pressure_field;
  row.mode = mode;
  row.metric = metric;
  row.unit = "1";
  row.limit = 0.1;
  return row;
}

GateOutcome judge(const GateRow& row, const RunResult& candidate) {
  GateEvidence evidence{};
  evidence.fields = [&](const GateRow& asked) {
    return field_metric(asked, candidate, reference, definition);
  };
  const RunStatus finished{RunState::finished, ""};
  return evaluate(row, {{"particles", finished}, {"mesh", finished}}, evidence);
}

const GateRow rms_row = row_of(Metric::pressure_field_rms, "whole"),
              tension_row = row_of(Metric::pressure_field_tension, "whole");

TEST(FieldMetrics, HoldOfTheReferencesOwnField) {
  for (const std::string mode : {"whole", "moment_1", "moment_3"})
    for (const Metric metric : {Metric::pressure_field_rms, Metric::pressure_field_tension}) {
      const GateOutcome outcome = judge(row_of(metric, mode), particles_with(at_rest));
      EXPECT_EQ(outcome.verdict, Verdict::pass) << outcome.message;
      EXPECT_NEAR(outcome.value.value, 0, 1e-9);
    }
}

TEST(FieldMetrics, AreOverThePressureUnderTheFillDepthTheMeanOverTheMomentsOrOfOneOfThem) {
  const auto raised = [](double x, double z) { return at_rest(x, z) + 0.2 * scale; };
  const GateOutcome outcome = judge(rms_row, particles_with(raised));
  EXPECT_EQ(outcome.verdict, Verdict::violated);
  EXPECT_NEAR(outcome.value.value, 0.2, 1e-9);
  EXPECT_EQ(outcome.message, "20 % is not ≤ 10 %");
  RunResult candidate = particles_with(at_rest);
  for (double& pressure : candidate.snapshots[1].pressure) pressure -= 0.3 * scale;
  for (const auto& [mode, value] : {std::pair{"whole", 0.1}, {"moment_1", 0.0}, {"moment_2", 0.3}})
    EXPECT_NEAR(judge(row_of(Metric::pressure_field_rms, mode), candidate).value.value, value,
                1e-9);
}

TEST(FieldMetrics, AreViolatedByAFieldThatIsScaledOrStandsElsewhere) {
  const auto tripled = [](double x, double z) { return 3 * at_rest(x, z); };
  const auto flipped = [](double x, double z) { return -at_rest(x, z); };
  for (const PressureAt& wrong : {PressureAt(tripled), PressureAt(flipped)})
    EXPECT_EQ(judge(rms_row, particles_with(wrong)).verdict, Verdict::violated);
  EXPECT_EQ(judge(tension_row, particles_with(flipped)).verdict, Verdict::violated);
  RunResult sunk = particles_with(at_rest);
  for (FieldSnapshot& field : sunk.snapshots)
    for (double& z : field.z) z -= 0.15;
  EXPECT_EQ(judge(rms_row, sunk).verdict, Verdict::violated);
}

TEST(FieldMetrics, CountOnlyATensionOfATwentiethOfTheDepthsPressure) {
  const auto with_hole = [](double tension) {
    return [tension](double x, double z) { return x < 0.3 ? -tension * scale : at_rest(x, z); };
  };
  EXPECT_NEAR(judge(tension_row, particles_with(with_hole(0.4))).value.value, 0.3, 1e-9);
  EXPECT_NEAR(judge(tension_row, particles_with(with_hole(0.051))).value.value, 0.3, 1e-9);
  EXPECT_EQ(judge(tension_row, particles_with(with_hole(0.049))).value.value, 0);
}

TEST(FieldMetrics, AreNotComparedWhereAMomentIsMissingOrBrokenOrHalfOfTheLiquidIsGone) {
  RunResult cut = particles_with(at_rest), poisoned = cut, none = cut, late = cut;
  cut.snapshots.pop_back();
  poisoned.snapshots[2].pressure[40] = NAN;
  none.snapshots.clear();
  late.snapshots[2].time += 0.011;  // more than half a sample
  const RunResult half =
      run_of("particles", {.width = 0.005, .height = 0.005, .length = 0.4}, at_rest);
  for (const RunResult& wrong : {cut, poisoned, none, late, half})
    for (const GateRow& row : {rms_row, tension_row})
      EXPECT_EQ(judge(row, wrong).verdict, Verdict::not_compared);
  EXPECT_EQ(judge(rms_row, cut).message, "particles has no field at 1.5 s");
  EXPECT_EQ(
      judge(rms_row, half).message,
      "the candidate's liquid covers 40 % of the reference's at 0.5 s; expected 50 % or more");
  EXPECT_EQ(judge(row_of(Metric::pressure_field_rms, "moment_1"), cut).verdict, Verdict::pass);
  EXPECT_EQ(judge(row_of(Metric::pressure_field_rms, "moment_3"), cut).verdict,
            Verdict::not_compared);
}

TEST(FieldMetrics, HaveAMomentForEachSnapshotTime) {
  EXPECT_EQ(moment_names(definition),
            (std::vector<std::string>{"moment_1", "moment_2", "moment_3"}));
  EXPECT_THROW(judged_moments("moment_4", reference, reference, definition), ComparisonError);
  CaseDefinition without = definition;
  without.snapshot_times.clear();
  EXPECT_THROW(compare_fields(reference, reference, without), ComparisonError);
}

}  // namespace
}  // namespace slosh::field_metrics_test
