#include "openfoam_cases/geometry/initial_liquid.hpp"

#include <gtest/gtest.h>

#include "openfoam_cases/tests/small_tank.hpp"

namespace slosh::openfoam::initial_liquid_test {
namespace {

double volume_of_cells(const SloshingTank& tank) {
  const TankMesh mesh(tank);
  double volume = 0;
  for (const Cell cell : mesh.cells()) volume += liquid_share(tank, mesh, cell);
  return volume * mesh.cell_width() * mesh.cell_height();
}

TEST(InitialLiquid, OfAColumnHasItsExactVolumeWhereverItsEdgesAre) {
  SloshingTank tank = still_tank();
  for (const double width : {0.0013, 0.055, 0.3571, 1.0999}) {
    for (const double depth : {0.0021, 0.13, 0.3577, 1.2999}) {
      tank.column_width = width;
      tank.fill_depth = depth;
      EXPECT_NEAR(volume_of_cells(tank), width * depth, 1e-15);
      EXPECT_EQ(initial_volume(tank, TankMesh(tank)), width * depth);
    }
  }
}

TEST(InitialLiquid, StandsInAColumnAtTheLeftWall) {
  SloshingTank tank = still_tank();  // cells of 0.055 x 0.13 m
  tank.column_width = 0.0825;
  tank.fill_depth = 0.195;
  EXPECT_EQ(liquid_share(tank, TankMesh(tank), {0, 0}), 1);
  EXPECT_NEAR(liquid_share(tank, TankMesh(tank), {1, 0}), 0.5, 1e-14);
  EXPECT_NEAR(liquid_share(tank, TankMesh(tank), {0, 1}), 0.5, 1e-14);
  EXPECT_NEAR(liquid_share(tank, TankMesh(tank), {1, 1}), 0.25, 1e-14);
  EXPECT_EQ(liquid_share(tank, TankMesh(tank), {2, 0}), 0);
  EXPECT_EQ(liquid_share(tank, TankMesh(tank), {0, 2}), 0);
}

// Of the obstacles two overlap, one pierces the surface and one hangs above it.
TEST(InitialLiquid, LeavesOutWhatObstaclesDisplace) {
  SloshingTank tank = still_tank();
  tank.obstacles = {{0.11, 0.33, 0, 0.13},
                    {0.22, 0.44, 0, 0.13},
                    {0.55, 0.66, 0.26, 0.52},
                    {0.99, 1.1, 0.91, 1.3}};
  const double expected = 1.1 * 0.357 - 0.33 * 0.13 - 0.11 * (0.357 - 0.26);
  const TankMesh mesh(tank);
  EXPECT_NEAR(initial_volume(tank, mesh), expected, 1e-14);
  EXPECT_NEAR(volume_of_cells(tank), expected, 1e-14);
  EXPECT_NEAR(initial_depth(tank, mesh, 3), 0.357 - 0.13, 1e-15);
  EXPECT_NEAR(initial_depth(tank, mesh, 10), 0.26, 1e-15);
  EXPECT_EQ(initial_depth(tank, mesh, 19), 0.357);
}

}  // namespace
}  // namespace slosh::openfoam::initial_liquid_test
