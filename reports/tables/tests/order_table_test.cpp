#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "reports/tables/case_tables.hpp"
#include "verification/assessment/observed_order.hpp"
#include "verification/tests/surge_results.hpp"

namespace slosh::order_table_test {
namespace {

ErrorAtSpacing at(double spacing, double error, double half_width = 0) {
  return {spacing, {error, half_width}};
}

TEST(ObservedOrder, IsTheExponentOfTheSpacing) {
  EXPECT_DOUBLE_EQ(*observed_order(at(0.02, 0.4), at(0.01, 0.1)), 2);
  EXPECT_DOUBLE_EQ(*observed_order(at(0.02, -0.4), at(0.01, 0.2)), 1);
  EXPECT_LT(*observed_order(at(0.02, 0.1), at(0.01, 0.2)), 0);
}

TEST(ObservedOrder, IsNoneOfAnErrorWithinItsInterval) {
  EXPECT_FALSE(observed_order(at(0.02, 0.4), at(0.01, 0.1, 0.1)));
  EXPECT_FALSE(observed_order(at(0.02, 0.4, 0.5), at(0.01, 0.1)));
  EXPECT_FALSE(observed_order(at(0.02, 0.4), at(0.01, 0)));
  EXPECT_FALSE(observed_order(at(0.02, std::nan("")), at(0.01, 0.1)));
}

TEST(LeastSquaresOrder, IsTheSlopeThroughAllSpacings) {
  EXPECT_NEAR(*least_squares_order({at(0.04, 1.6), at(0.02, 0.4), at(0.01, 0.1)}), 2, 1e-12);
  // Slopes of 1 and 2 between equal ratios: the line has their mean.
  EXPECT_NEAR(*least_squares_order({at(0.04, 0.8), at(0.02, 0.4), at(0.01, 0.1)}), 1.5, 1e-12);
}

TEST(LeastSquaresOrder, NeedsThreeErrorsThatHaveASize) {
  EXPECT_FALSE(least_squares_order({at(0.04, 1.6), at(0.02, 0.4)}));
  EXPECT_FALSE(least_squares_order({at(0.04, 1.6), at(0.02, 0.4), at(0.01, 0.1, 0.2)}));
}

// The surge at these spacings, with errors of the elevation of spacing squared.
CaseAssessment assess_spacings(const std::vector<double>& spacings) {
  std::vector<ScaledRun> runs;
  for (const double spacing : spacings)
    runs.push_back({"spacing_" + std::to_string(runs.size() + 1),
                    SphRun{"recommended", spacing, spacing},
                    1 + 100 * spacing * spacing,
                    {.wall_time = 1, .user_time = 1, .steps = 10, .elements = 100}});
  return assess_scaled(runs);
}

TEST(OrderTable, TellsTheOrderOfAKnownError) {
  const auto table = order_table(assess_spacings({0.01, 0.04, 0.02}));
  ASSERT_TRUE(table);
  ASSERT_EQ(table->rows.size(), 4u);
  EXPECT_EQ(table->rows[0][1], "40");  // coarsest first, whatever the order of the case
  EXPECT_EQ(table->rows[0][3], "");
  EXPECT_EQ(table->rows[1][3], "2.00");
  EXPECT_EQ(table->rows[2][3], "2.00");
  EXPECT_EQ(table->rows[3][1], "all, least squares");
  EXPECT_EQ(table->rows[3][3], "2.00");
  for (const auto& row : table->rows) EXPECT_EQ(row.size(), table->header.size());
}

TEST(OrderTable, TakesAnExternalProgramsMethodForAScheme) {
  std::vector<ScaledRun> runs;
  for (const double spacing : {0.01, 0.02, 0.04})
    runs.push_back({"mine_" + std::to_string(runs.size() + 1),
                    ExternalRun{{"my_sph"}, {}, {}, {}, {}, "my_sph", spacing},
                    1 + 100 * spacing * spacing,
                    {}});
  const auto table = order_table(assess_scaled(runs));
  ASSERT_TRUE(table);
  ASSERT_EQ(table->rows.size(), 4u);
  EXPECT_EQ(table->rows[0][0], "my_sph");
  EXPECT_EQ(table->rows[3][3], "2.00");
}

TEST(OrderTable, NeedsThreeSpacings) { EXPECT_FALSE(order_table(assess_spacings({0.01, 0.02}))); }

TEST(OrderTable, LeavesOutARunThatChangesItsScheme) {
  CaseAssessment assessment = assess_spacings({0.01, 0.02, 0.04});
  std::get<SphRun>(assessment.definition.runs.back().solver).variant = "antuono";
  EXPECT_FALSE(order_table(assess(assessment.definition, assessment.runs)));
}

}  // namespace
}  // namespace slosh::order_table_test
