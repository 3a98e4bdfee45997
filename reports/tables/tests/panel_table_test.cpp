// The tables of a case's panels: the means of the solvers, who is apart, and what is told of those
// that are left out.
#include <gtest/gtest.h>

#include "reports/tables/case_tables.hpp"
#include "verification/tests/panel_runs.hpp"

namespace slosh::panel_table_test {
namespace {

TEST(PanelTable, ShowsTheMeansAndNamesTheOneThatIsApart) {
  const auto tables = panel_tables(panel_runs());
  ASSERT_EQ(tables.size(), 2U);
  EXPECT_EQ(tables[0].id, "impacts-panel-impacts");
  EXPECT_EQ(tables[0].header,
            (std::vector<std::string>{"part", "metric", "particles", "cells", "sharp", "air",
                                      "who is apart", "compressibility of the air",
                                      "left out (reason)"}));
  const auto& peak = tables[0].rows.at(0);
  EXPECT_EQ(peak[0], "impact_1");
  EXPECT_EQ(peak[1], "peak [Pa]");
  EXPECT_EQ(peak[3], "3710 ± 110 (sd 88, 5)");
  EXPECT_TRUE(peak[6].starts_with("particles: 18")) << peak[6];
  EXPECT_NE(peak[6].find("; the others agree (p "), std::string::npos) << peak[6];
  EXPECT_TRUE(peak[7].starts_with("2.0 ± ")) << peak[7];
  for (const auto& table : tables)
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.header.size());
  EXPECT_TRUE(tables[1].rows.at(1)[6].starts_with("nobody: all agree (p ")) << tables[1].rows[1][6];
}

TEST(PanelTable, TellsWhatIsLeftOutAndWhatNeverCame) {
  CaseAssessment assessment = panel_runs();
  for (auto& [run, status] : assessment.runs.status)
    if (run.starts_with("air") || run.starts_with("sharp")) {
      assessment.runs.results.erase(run);
      status = {RunState::not_selected, ""};
    }
  assessment.runs.results.at("cells_2") = result_with("cells_2", {pressure_of({.impacts = 2})});
  const auto table = panel_tables(assessment).at(0);
  const auto& row = table.rows.at(6);  // the peak of impact 3
  EXPECT_EQ(row[5], "left out: 0 usable");
  EXPECT_TRUE(row[3].ends_with("; never in 1 of 5")) << row[3];
  EXPECT_TRUE(row[6].ends_with("of two solvers neither can be named")) << row[6];
  EXPECT_EQ(row[7], "not known");
  EXPECT_TRUE(row[8].starts_with("sharp (not selected); sharp_2 ")) << row[8];
}

TEST(PanelTable, IsLeftOutWithoutPanels) {
  CaseAssessment assessment = panel_runs();
  assessment.definition.panels.clear();
  EXPECT_TRUE(panel_tables(assessment).empty());
}

}  // namespace
}  // namespace slosh::panel_table_test
