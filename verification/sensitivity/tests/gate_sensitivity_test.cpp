// The sensitivity of a case's rows, which are judged with all their evidence.
#include "verification/sensitivity/gate_sensitivity.hpp"

#include <gtest/gtest.h>

#include "verification/tests/surge_results.hpp"

namespace slosh::gate_sensitivity_test {
namespace {

CaseAssessment surge_with(const std::vector<GateRow>& gate) {
  CaseDefinition definition = surge_case();
  definition.gate = gate;
  return assess(definition, surge_runs());
}

TEST(GateSensitivity, SaysWhichSpoilingsARowDetects) {
  const auto sensitivity =
      gate_sensitivity(surge_with({surge_row("forced", Metric::amplitude_error, "1", 0.04),
                                   surge_row("forced", Metric::amplitude_error, "1", 0.5)}));
  ASSERT_EQ(sensitivity.size(), 2U);
  ASSERT_TRUE(sensitivity[0].passes_as_it_is);
  EXPECT_EQ(sensitivity[0].detects, (std::map<Spoiling, bool>{{Spoiling::amplitude, true},
                                                              {Spoiling::lag, false},
                                                              {Spoiling::datum, false},
                                                              {Spoiling::noise, true},
                                                              {Spoiling::truncation, true},
                                                              {Spoiling::not_a_number, true}}));
  EXPECT_FALSE(sensitivity[1].detects.at(Spoiling::amplitude)) << "half of the amplitude may err";
}

TEST(GateSensitivity, SaysOnlyThatARowDoesNotPassAsItIs) {
  TimeSeries high = elevation_of({});
  for (double& value : high.value) value *= 1.2;
  CaseDefinition definition = surge_case();
  definition.gate = {surge_row("forced", Metric::amplitude_error, "1", 0.05)};
  const CaseAssessment assessment = assess(definition, surge_runs_with("particles", high));
  const auto sensitivity = gate_sensitivity(assessment);
  EXPECT_FALSE(sensitivity.at(0).passes_as_it_is);
  EXPECT_TRUE(sensitivity.at(0).detects.empty());
}

TEST(GateSensitivity, MeasuresTheDatumByTheFillDepthAndItsPressure) {
  const CaseDefinition definition = surge_case();
  EXPECT_DOUBLE_EQ(datum_of(definition, "elevation@right"), 0.35);
  EXPECT_DOUBLE_EQ(datum_of(definition, "wall_pressure@side"), 1000 * 9.81 * 0.35);
  EXPECT_DOUBLE_EQ(datum_of(definition, "wall_pressure@side/filtered"), 1000 * 9.81 * 0.35);
  EXPECT_EQ(datum_of(definition, "force_x"), 0);
}

TEST(GateSensitivity, NamesTheRowsThatPassWithNaNOrATruncatedSeries) {
  const RowSensitivity blind{
      surge_row("forced", Metric::amplitude_error, "1", 0.05),
      true,
      {{Spoiling::lag, false}, {Spoiling::truncation, false}, {Spoiling::not_a_number, false}}};
  const std::string row = "particles, forced amplitude_error of elevation@right: ";
  EXPECT_EQ(blind_rows({blind}),
            (std::vector<std::string>{row + "passes with truncation", row + "passes with NaN"}));
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
    ASSERT_TRUE(one.passes_as_it_is);
    for (const Spoiling spoiling :
         {Spoiling::lag, Spoiling::datum, Spoiling::truncation, Spoiling::not_a_number})
      EXPECT_TRUE(one.detects.at(spoiling))
          << short_row_name(one.row) << ", " << spoiling_name(spoiling);
  }
}

}  // namespace
}  // namespace slosh::gate_sensitivity_test
