#include <gtest/gtest.h>

#include <cmath>

#include "reports/tables/case_tables.hpp"
#include "verification/tests/surge_results.hpp"

namespace slosh::distance_table_test {
namespace {

TEST(DistanceTable, ComparesTheFinestOfEachKind) {
  TimeSeries half = elevation_of({});
  for (double& value : half.value) value *= 0.5;
  const CaseAssessment assessment = assess(surge_case(), surge_runs_with("particles", half));
  const auto table = distance_table(assessment);
  ASSERT_TRUE(table.has_value());
  EXPECT_EQ(table->header, (std::vector<std::string>{"run", "theory", "theory_with_gas",
                                                     "particles", "fine_mesh"}));
  EXPECT_NE(table->caption.find("`particles` is an outlier"), std::string::npos) << table->caption;
  // rms(a - a/2) over the root of rms(a) rms(a/2) is 1/sqrt(2) of a wave about zero.
  EXPECT_NEAR(std::stod(table->rows.at(0).at(3)), 100 / std::sqrt(2.0), 2);
  EXPECT_EQ(table->rows.at(0).at(3), table->rows.at(2).at(1));
}

}  // namespace
}  // namespace slosh::distance_table_test
