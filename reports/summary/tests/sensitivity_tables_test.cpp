#include "reports/summary/sensitivity_tables.hpp"

#include <gtest/gtest.h>

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

TEST(SensitivityTable, OnlySaysThatARowDoesNotPassAsItIs) {
  const reports::Table table = sensitivity_table(surge(), {{amplitude_row(), {false, {}}}});
  EXPECT_EQ(table.id, "surge-strength");
  ASSERT_EQ(table.rows.at(0).size(), table.header.size());
  EXPECT_EQ(table.rows[0].front(), "particles, forced amplitude_error of elevation@right");
  EXPECT_EQ(table.rows[0].back(), "does not pass as it is");
}

TEST(SensitivityTable, ShowsTheLargerOfTheStrengthsDetectedBothWays) {
  const MutationTrials trials{true,
                              {{{MutationKind::louder, 0.05}, true, true},
                               {{MutationKind::quieter, 0.05}, false, false},
                               {{MutationKind::quieter, 0.1}, true, true}}};
  const reports::Table table = sensitivity_table(surge(), {{amplitude_row(), trials}});
  ASSERT_EQ(table.rows.at(0).size(), table.header.size());
  EXPECT_EQ(table.rows[0][1], "10");
  EXPECT_EQ(table.rows[0][2], "not detected");
}

TEST(CoverageTable, NamesWhatTheRowsOfACaseMiss) {
  CaseCoverage coverage{"surge", "", 3, 2, {}};
  for (const RequiredDetection& one : required_detections)
    coverage.detections[one.name] = {Coverage::detected, {}};
  coverage.detections["noise"] = {Coverage::missed, {}};
  const reports::Table table = coverage_table("coverage", {coverage});
  EXPECT_EQ(table.rows.at(0), (std::vector<std::string>{"surge", "2", "3", "detected", "detected",
                                                        "detected", "MISSED", "detected"}));
}

}  // namespace
}  // namespace slosh::sensitivity_tables_test
