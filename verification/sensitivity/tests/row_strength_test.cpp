// What a case's rows detect, with the whole evidence behind their judge.
#include "verification/sensitivity/row_strength.hpp"

#include <gtest/gtest.h>

#include "verification/tests/surge_results.hpp"

namespace slosh::row_strength_test {
namespace {

CaseAssessment surge_with(const std::vector<GateRow>& gate) {
  CaseDefinition definition = surge_case();
  definition.gate = gate;
  return assess(definition, surge_runs());
}

TEST(RowStrength, FindsTheSmallestChangeThatARowDetects) {
  const CaseAssessment assessment =
      surge_with({surge_row("forced", Metric::amplitude_error, "1", 0.04)});
  const auto strengths = row_strengths(assessment, 2);
  ASSERT_EQ(strengths.size(), 1U);
  ASSERT_TRUE(strengths[0].strength.passes_as_it_is);
  EXPECT_EQ(detected_from(strengths[0].strength, MutationKind::louder), 0.05);
  EXPECT_TRUE(detected_from(strengths[0].strength, MutationKind::not_a_number).has_value());
  EXPECT_TRUE(broken_claims(strengths).empty());
}

TEST(RowStrength, ShowsAWideLimitByWhatItLetsPass) {
  const auto strengths =
      row_strengths(surge_with({surge_row("forced", Metric::amplitude_error, "1", 0.5)}), 1);
  EXPECT_FALSE(detected_from(strengths.at(0).strength, MutationKind::louder).has_value());
}

TEST(RowStrength, SaysOnlyThatARowDoesNotPassAsItIs) {
  TimeSeries high = elevation_of({});
  for (double& value : high.value) value *= 1.2;
  CaseDefinition definition = surge_case();
  definition.gate = {surge_row("forced", Metric::amplitude_error, "1", 0.05)};
  const CaseAssessment assessment = assess(definition, surge_runs_with("particles", high));
  const auto strengths = row_strengths(assessment, 1);
  EXPECT_TRUE(strengths.at(0).strength.outcomes.empty());
  EXPECT_EQ(strength_table(assessment, strengths).rows.at(0).back(), "does not pass as it is");
}

TEST(RowStrength, FindsOutARowThatJudgesNothing) {
  const auto strengths =
      row_strengths(surge_with({surge_row("forced", Metric::amplitude_error, "1", 1e300),
                                surge_row("forced", Metric::phase_lag, "deg", 5)}),
                    1);
  EXPECT_EQ(
      broken_claims(strengths),
      std::vector<std::string>{"particles, forced amplitude_error of elevation@right: detects "
                               "no change of its candidate's values"});
}

TEST(RowStrength, MeasuresTheDatumByTheFillDepthAndItsPressure) {
  const CaseDefinition definition = surge_case();
  EXPECT_DOUBLE_EQ(datum_of(definition, "elevation@right"), 0.35);
  EXPECT_DOUBLE_EQ(datum_of(definition, "wall_pressure@side"), 1000 * 9.81 * 0.35);
  EXPECT_DOUBLE_EQ(datum_of(definition, "wall_pressure@side/filtered"), 1000 * 9.81 * 0.35);
  EXPECT_EQ(datum_of(definition, "force_x"), 0);
}

TEST(RowStrength, FindsOutARowThatLetsPassWhatItMustDetect) {
  RowStrength blind{
      surge_row("forced", Metric::amplitude_error, "1", 0.05),
      {true,
       {{{MutationKind::louder, 0.2}, true, false}, {{MutationKind::quieter, 0.2}, true, true}}}};
  ASSERT_EQ(broken_claims({blind}).size(), 1U);
  EXPECT_EQ(broken_claims({blind})[0],
            "particles, forced amplitude_error of elevation@right: louder 0.2 should be detected "
            "and is not");
}

}  // namespace
}  // namespace slosh::row_strength_test
