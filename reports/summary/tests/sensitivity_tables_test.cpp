#include <gtest/gtest.h>

#include "reports/summary/report_sections.hpp"

namespace slosh::sensitivity_tables_test {
namespace {

CaseAssessment surge() {
  CaseAssessment assessment{};
  assessment.definition.name = "surge";
  return assessment;
}

GateRow amplitude_row() {
  GateRow row{};
  row.candidate = "particles";
  row.quantity = "elevation@right";
  row.mode = "forced";
  row.metric = Metric::amplitude_error;
  return row;
}

TEST(SensitivityTable, HasAColumnPerSpoiling) {
  const reports::Table table = sensitivity_table(
      surge(), {{amplitude_row(), false, {}},
                {amplitude_row(),
                 true,
                 {{Spoiling::amplitude, true}, {Spoiling::lag, false}, {Spoiling::noise, true}}}});
  EXPECT_EQ(table.id, "surge-strength");
  ASSERT_EQ(table.rows.at(0).size(), table.header.size());
  EXPECT_EQ(table.rows[0].front(), "particles, forced amplitude_error of elevation@right");
  EXPECT_EQ(table.rows[0].back(), "does not pass as it is");
  EXPECT_EQ(table.rows[1][1], "detected");
  EXPECT_EQ(table.rows[1][2], "not detected");
  EXPECT_EQ(table.rows[1][3], "not applicable");
}

TEST(CoverageTable, NamesWhatTheRowsOfACaseMiss) {
  CaseCoverage coverage{"surge", "", 3, 2, {}};
  for (const RequiredDetection& one : required_detections)
    coverage.detections[one.spoiling] = {Coverage::detected, {}};
  coverage.detections[Spoiling::noise] = {Coverage::missed, {}};
  const reports::Table table = coverage_table("coverage", {coverage});
  EXPECT_EQ(table.rows.at(0), (std::vector<std::string>{"surge", "2", "3", "detected", "detected",
                                                        "detected", "MISSED", "detected"}));
}

}  // namespace
}  // namespace slosh::sensitivity_tables_test
