#include "openfoam_cases/geometry/gauge_columns.hpp"

#include <gtest/gtest.h>

#include "openfoam_cases/tests/small_tank.hpp"

namespace slosh::openfoam::gauge_columns_test {
namespace {

SloshingTank metre_tank(int cells_x) {
  SloshingTank tank = small_tank();
  tank.length = 1;
  tank.cells_x = cells_x;
  return tank;
}

TEST(GaugeColumns, ReadOneColumnWhereTheGaugeIsAtItsCentre) {
  const GaugeColumns columns = gauge_columns(TankMesh(metre_tank(50)), 0.95);
  EXPECT_NEAR(columns.left + columns.right_weight, 47, 1e-12);
}

TEST(GaugeColumns, ReadTheMeanOfTwoWhereTheGaugeIsOnTheirEdge) {
  const GaugeColumns columns = gauge_columns(TankMesh(metre_tank(100)), 0.95);
  EXPECT_EQ(columns.left, 94);
  EXPECT_NEAR(columns.right_weight, 0.5, 1e-12);
}

// A linear profile is reproduced everywhere, also at the walls.
TEST(GaugeColumns, ReproduceALinearSurfaceFromWallToWall) {
  const TankMesh mesh(metre_tank(7));
  for (int i = 0; i <= 100; ++i) {
    const double x = i / 100.0;
    const GaugeColumns columns = gauge_columns(mesh, x);
    ASSERT_GE(columns.left, 0);
    ASSERT_LE(columns.left + 1, 6);
    const auto centre = [](int column) { return (column + 0.5) / 7; };
    EXPECT_NEAR(std::lerp(centre(columns.left), centre(columns.left + 1), columns.right_weight), x,
                1e-14);
  }
}

TEST(GaugeColumns, AreListedOnceEach) {
  SloshingTank tank = metre_tank(100);
  tank.gauges = {{"a", 0.95}, {"b", 0.941}, {"c", 0.95}};
  EXPECT_EQ(columns_read(tank, TankMesh(tank)), (std::vector<int>{93, 94, 95}));
}

// The cells are of 0.05 m in a tank of 1 x 0.5 m.
TankMesh mesh_with(std::vector<Obstacle> obstacles) {
  SloshingTank tank = metre_tank(20);
  tank.height = 0.5;
  tank.obstacles = std::move(obstacles);
  return TankMesh(tank);
}

TEST(GaugeColumns, ReadNothingBeyondAnObstaclesSide) {
  const TankMesh mesh = mesh_with({{0.4, 0.5, 0, 0.2}});
  const GaugeColumns before = gauge_columns(mesh, 0.39);
  EXPECT_EQ(before.left, 6);
  EXPECT_EQ(before.right, 7);
  EXPECT_NEAR(before.right_weight, 1.3, 1e-12);
  const GaugeColumns over = gauge_columns(mesh, 0.41);
  EXPECT_EQ(over.left, 8);
  EXPECT_NEAR(over.right_weight, -0.3, 1e-12);
}

TEST(GaugeColumns, ReadTheOneColumnOfANarrowGap) {
  const TankMesh mesh = mesh_with({{0.3, 0.4, 0, 0.2}, {0.45, 0.5, 0, 0.2}});
  const GaugeColumns gap = gauge_columns(mesh, 0.41);
  EXPECT_EQ(gap.left, 8);
  EXPECT_EQ(gap.right, 8);
}

TEST(SurfaceLevel, IsTheDepthWithoutObstacles) {
  EXPECT_EQ(surface_level(mesh_with({}), 3, 0.123), 0.123);
}

TEST(SurfaceLevel, IsLiftedByWhatIsBelowIt) {
  const TankMesh mesh =
      mesh_with({{0.4, 0.5, 0, 0.1}, {0.4, 0.5, 0.2, 0.3}, {0.4, 0.5, 0.45, 0.5}});
  EXPECT_NEAR(surface_level(mesh, 8, 0), 0.1, 1e-15) << "the top of a dry step";
  EXPECT_NEAR(surface_level(mesh, 8, 0.05), 0.15, 1e-15);
  EXPECT_NEAR(surface_level(mesh, 8, 0.1 + 1e-8), 0.2, 1e-7) << "up to an underside";
  EXPECT_NEAR(surface_level(mesh, 8, 0.15), 0.35, 1e-15);
  EXPECT_NEAR(surface_level(mesh, 8, 0.25), 0.45, 1e-15) << "full";
}

}  // namespace
}  // namespace slosh::openfoam::gauge_columns_test
