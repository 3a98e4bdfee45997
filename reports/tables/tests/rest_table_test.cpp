#include <gtest/gtest.h>

#include <cmath>

#include "reports/tables/case_tables.hpp"
#include "verification/tests/surge_results.hpp"

namespace slosh::rest_table_test {
namespace {

// The surge's case and window (from 1 s); its run `particles` records these values from 0 s on, one
// a second.
CaseAssessment recorded(const std::vector<double>& values) {
  CaseDefinition definition = surge_case();
  definition.gate.clear();
  CaseRuns runs = surge_runs();
  RunResult& result = runs.results.at("particles");
  for (const char* name : rest_quantities) {
    TimeSeries series{name, "1", {}, values};
    for (std::size_t i = 0; i < values.size(); ++i) series.time.push_back(static_cast<double>(i));
    result.series.push_back(series);
  }
  return {definition, runs, {}, {}, {}};
}

TEST(RestTable, IsLeftOutWhereNoRunRecordsHowFarFromRestItIs) {
  EXPECT_FALSE(rest_table({surge_case(), surge_runs(), {}, {}, {}}));
}

TEST(RestTable, GivesTheLargestMagnitudesOfTheWholeRunAndOfTheWindow) {
  const auto table = rest_table(recorded({-0.5, 0.25, -0.3}));
  ASSERT_TRUE(table);
  ASSERT_EQ(table->rows.size(), 1u);
  EXPECT_EQ(table->header.at(1), "hydrostatic pressure error");
  EXPECT_EQ(table->rows[0].size(), table->header.size());
  EXPECT_EQ(table->rows[0].at(1), "0.5");
  EXPECT_EQ(table->rows[0].at(2), "0.3");
}

TEST(RestTable, SaysWhereAValueIsNotFinite) {
  for (const double broken : {NAN, INFINITY})
    EXPECT_EQ(rest_table(recorded({0.5, broken, 0.3}))->rows[0].at(1), "not available");
}

}  // namespace
}  // namespace slosh::rest_table_test
