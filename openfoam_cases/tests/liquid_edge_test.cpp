// Where the liquid ends: its highest surface over a gauge, and its front on the bottom.
#include "openfoam_cases/geometry/liquid_edge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "openfoam_cases/tests/small_tank.hpp"

namespace slosh::openfoam::liquid_edge_test {
namespace {

// The cells are of 0.05 m.
SloshingTank metre_tank() {
  SloshingTank tank = still_tank();
  tank.length = 1;
  tank.height = 0.5;
  tank.cells_x = 20;
  tank.cells_z = 10;
  return tank;
}

std::vector<double> filled_to(const TankMesh& mesh, int column, double level) {
  std::vector<double> fractions;
  for (const int row : free_rows(mesh, column)) {
    fractions.push_back(std::clamp(level / mesh.cell_height() - row, 0.0, 1.0));
  }
  return fractions;
}

TEST(HighestSurface, OfALevelLiquidIsFoundToATenthOfACell) {
  const TankMesh mesh(metre_tank());
  for (int i = 300; i <= 5000; ++i) {
    const double level = i / 10000.0;
    ASSERT_NEAR(highest_surface(mesh, 4, filled_to(mesh, 4, level)), level, 0.09 * 0.05);
  }
  EXPECT_NEAR(highest_surface(mesh, 4, filled_to(mesh, 4, 0.5)), 0.5, 1e-15) << "at the roof";
}

TEST(HighestSurface, IsADropsAboveTheLiquid) {
  const TankMesh mesh(metre_tank());
  std::vector<double> fractions = filled_to(mesh, 4, 0.2);
  fractions[7] = 0.8;
  EXPECT_NEAR(highest_surface(mesh, 4, fractions), 0.05 * (7.5 + 0.3 / 0.8), 1e-14);
  fractions[7] = 0.4;
  EXPECT_NEAR(highest_surface(mesh, 4, fractions), 0.2, 1e-14) << "too thin a drop";
}

TEST(HighestSurface, OfADryColumnIsItsGround) {
  SloshingTank tank = metre_tank();
  tank.obstacles = {{0.2, 0.3, 0, 0.1}};
  const TankMesh mesh(tank);
  EXPECT_EQ(highest_surface(mesh, 2, std::vector<double>(10, 0.3)), 0);
  EXPECT_NEAR(highest_surface(mesh, 4, std::vector<double>(8, 0.0)), 0.1, 1e-15);
}

TEST(HighestSurface, IsProbedInTheNearestColumnOfEachGaugeOnce) {
  SloshingTank tank = metre_tank();
  tank.gauges = {{"wall", 1}, {"a", 0.21}, {"b", 0.24}, {"edge", 0.5}};
  EXPECT_EQ(probed_columns(tank, TankMesh(tank)), (std::vector<int>{4, 10, 19}));
}

std::vector<double> row_up_to(const TankMesh& mesh, double front) {
  std::vector<double> fractions;
  for (const int column : bottom_columns(mesh)) {
    fractions.push_back(std::clamp(front / mesh.cell_width() - column, 0.0, 1.0));
  }
  return fractions;
}

TEST(FrontPosition, OfASharpFrontIsFoundToATenthOfACellAndNeverJumps) {
  const TankMesh mesh(metre_tank());
  double previous = 0.05;
  for (int i = 500; i <= 10000; ++i) {
    const double front = i / 10000.0;
    const double found = front_position(mesh, row_up_to(mesh, front));
    ASSERT_NEAR(found, front, 0.09 * mesh.cell_width());
    ASSERT_GE(found, previous - 1e-12);
    ASSERT_LT(found - previous, 0.01 * mesh.cell_width());
    previous = found;
  }
  EXPECT_NEAR(previous, 1, 1e-12) << "at the wall";
}

TEST(FrontPosition, OfAFrontOnACellFaceIsExact) {
  const TankMesh mesh(metre_tank());
  for (int column = 1; column <= 20; ++column) {
    EXPECT_NEAR(front_position(mesh, row_up_to(mesh, 0.05 * column)), 0.05 * column, 1e-14);
  }
}

// A front that is smeared over many cells as a linear ramp is where the ramp is half full.
TEST(FrontPosition, OfASmearedFrontIsItsMiddle) {
  const TankMesh mesh(metre_tank());
  std::vector<double> fractions;
  for (int column = 0; column < 20; ++column) {
    fractions.push_back(std::clamp(0.5 - ((column + 0.5) * 0.05 - 0.513) / 0.3, 0.0, 1.0));
  }
  EXPECT_NEAR(front_position(mesh, fractions), 0.513, 1e-14);
}

TEST(FrontPosition, OverlooksBubblesBehindItAndIsTheWallWhereNothingIsWet) {
  const TankMesh mesh(metre_tank());
  std::vector<double> fractions = row_up_to(mesh, 0.6);
  fractions[0] = fractions[5] = 0;
  EXPECT_NEAR(front_position(mesh, fractions), 0.6, 1e-14);
  EXPECT_EQ(front_position(mesh, std::vector<double>(20, 0.49)), 0);
}

TEST(FrontPosition, StopsAtAnObstacleAndGoesOnBehindIt) {
  SloshingTank tank = metre_tank();
  tank.obstacles = {{0.5, 0.7, 0, 0.2}};
  const TankMesh mesh(tank);
  ASSERT_EQ(bottom_columns(mesh).size(), 16u);
  std::vector<double> fractions(16, 0.0);
  std::fill_n(fractions.begin(), 10, 1.0);
  fractions[9] = 0.8;
  EXPECT_NEAR(front_position(mesh, fractions), 0.49, 1e-14);
  fractions[9] = 1 + 1e-6;
  EXPECT_NEAR(front_position(mesh, fractions), 0.5, 1e-14);
  fractions[10] = fractions[11] = 1;
  EXPECT_NEAR(front_position(mesh, fractions), 0.8, 1e-14);
}

}  // namespace
}  // namespace slosh::openfoam::liquid_edge_test
