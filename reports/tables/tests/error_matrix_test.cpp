#include "reports/tables/error_matrix.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "verification/tests/surge_results.hpp"

namespace slosh::error_matrix_test {
namespace {

TEST(ErrorMatrix, NamesTheOneThatStandsApart) {
  const std::vector<std::vector<double>> distances{
      {0, 0.02, 0.30}, {0.02, 0, 0.31}, {0.30, 0.31, 0}};
  EXPECT_EQ(odd_one_out(distances), 2U);
}

TEST(ErrorMatrix, NamesNobodyWhereAllAreAsFarApart) {
  EXPECT_EQ(odd_one_out({{0, 0.1, 0.1}, {0.1, 0, 0.1}, {0.1, 0.1, 0}}), std::nullopt);
  EXPECT_EQ(odd_one_out({{0, 0.1, 0.15}, {0.1, 0, 0.15}, {0.15, 0.15, 0}}), std::nullopt);
}

TEST(ErrorMatrix, LeavesOutWhatCannotBeCompared) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(odd_one_out({{0, nan, nan}, {nan, 0, nan}, {nan, nan, 0}}), std::nullopt);
  EXPECT_EQ(odd_one_out({{0, 0.1, 1, nan}, {0.1, 0, 1, nan}, {1, 1, 0, nan}, {nan, nan, nan, 0}}),
            2U);
}

TEST(ErrorMatrix, ComparesTheFinestOfEachKind) {
  TimeSeries half = elevation_of({});
  for (double& value : half.value) value *= 0.5;
  const CaseAssessment assessment = assess(surge_case(), surge_runs_with("particles", half));
  const auto table = error_matrix(assessment);
  ASSERT_TRUE(table.has_value());
  EXPECT_EQ(table->header, (std::vector<std::string>{"run", "theory", "theory_with_gas",
                                                     "particles", "fine_mesh"}));
  EXPECT_NE(table->caption.find("`particles` stands apart"), std::string::npos) << table->caption;
  // rms(a - a/2) over the root of rms(a) rms(a/2) is 1/sqrt(2) of a wave about zero.
  EXPECT_NEAR(std::stod(table->rows.at(0).at(3)), 100 / std::sqrt(2.0), 2);
  EXPECT_EQ(table->rows.at(0).at(3), table->rows.at(2).at(1));
}

}  // namespace
}  // namespace slosh::error_matrix_test
