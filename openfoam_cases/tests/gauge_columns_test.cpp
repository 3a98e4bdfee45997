#include "openfoam_cases/gauge_columns.hpp"

#include <gtest/gtest.h>

#include "openfoam_cases/tests/small_tank.hpp"

namespace slosh::openfoam {
namespace {

SurgingTank metre_tank(int cells_x) {
  SurgingTank tank = small_tank();
  tank.length = 1;
  tank.cells_x = cells_x;
  return tank;
}

TEST(GaugeColumns, ReadOneColumnWhereTheGaugeIsAtItsCentre) {
  const GaugeColumns columns = gauge_columns(metre_tank(50), 0.95);
  EXPECT_NEAR(columns.left + columns.right_weight, 47, 1e-12);
}

TEST(GaugeColumns, ReadTheMeanOfTwoWhereTheGaugeIsOnTheirEdge) {
  const GaugeColumns columns = gauge_columns(metre_tank(100), 0.95);
  EXPECT_EQ(columns.left, 94);
  EXPECT_NEAR(columns.right_weight, 0.5, 1e-12);
}

// A linear profile is reproduced everywhere, at the walls too.
TEST(GaugeColumns, ReproduceALinearSurfaceFromWallToWall) {
  const SurgingTank tank = metre_tank(7);
  for (int i = 0; i <= 100; ++i) {
    const double x = i / 100.0;
    const GaugeColumns columns = gauge_columns(tank, x);
    ASSERT_GE(columns.left, 0);
    ASSERT_LE(columns.left + 1, 6);
    const auto centre = [](int column) { return (column + 0.5) / 7; };
    EXPECT_NEAR(std::lerp(centre(columns.left), centre(columns.left + 1), columns.right_weight), x,
                1e-14);
  }
}

TEST(GaugeColumns, AreListedOnceEach) {
  SurgingTank tank = metre_tank(100);
  tank.gauges = {{"a", 0.95}, {"b", 0.941}, {"c", 0.95}};
  EXPECT_EQ(columns_read(tank), (std::vector<int>{93, 94, 95}));
}

}  // namespace
}  // namespace slosh::openfoam
