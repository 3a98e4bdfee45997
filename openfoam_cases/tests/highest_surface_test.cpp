#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "openfoam_cases/geometry/liquid_edge.hpp"
#include "openfoam_cases/tests/small_tank.hpp"

namespace slosh::openfoam::highest_surface_test {
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

}  // namespace
}  // namespace slosh::openfoam::highest_surface_test
