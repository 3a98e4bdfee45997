// The liquid that a case starts with: level, in a column, under a wave and disturbed.
#include "openfoam_cases/geometry/initial_liquid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>
#include <utility>

#include "openfoam_cases/check_tank.hpp"
#include "openfoam_cases/tests/run_fixture.hpp"
#include "openfoam_cases/tests/small_tank.hpp"
#include "openfoam_cases/time_step.hpp"

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

constexpr double pi = std::numbers::pi;

SloshingTank waved_tank(int mode, double amplitude) {
  SloshingTank tank = still_tank();  // 20 x 10 cells of 0.055 x 0.13 m, filled to 0.357 m
  tank.initial_wave = InitialWave{mode, amplitude};
  return tank;
}

TEST(WavyLevel, FillsTheCellsWithTheStillLiquidsVolumeWhateverTheWave) {
  for (const int mode : {1, 2, 3, 19, 40, 41})
    for (const double amplitude : {1e-4, -0.02, 0.13, -0.35}) {
      const SloshingTank tank = waved_tank(mode, amplitude);
      double volume = 0;
      for (const Cell cell : TankMesh(tank).cells())
        volume += liquid_share(tank, TankMesh(tank), cell);
      EXPECT_NEAR(volume * 0.055 * 0.13, 1.1 * 0.357, 1e-14) << mode << " " << amplitude;
      EXPECT_EQ(initial_volume(tank, TankMesh(tank)), 1.1 * 0.357);
    }
}

TEST(WavyLevel, FillsEveryColumnUpToItsMeanHeight) {
  const SloshingTank tank = waved_tank(3, 0.2);
  const TankMesh mesh(tank);
  const double k = 3 * pi / 1.1;
  for (int column = 0; column < 20; ++column) {
    double depth = 0;
    for (int row = 0; row < 10; ++row)
      depth += 0.13 * liquid_share(tank, TankMesh(tank), {column, row});
    const double mean =
        0.357 +
        0.2 * (std::sin(k * 0.055 * (column + 1)) - std::sin(k * 0.055 * column)) / (k * 0.055);
    EXPECT_NEAR(depth, mean, 1e-14) << column;
    EXPECT_NEAR(initial_depth(tank, mesh, column), mean, 1e-14) << column;
  }
}

// Integrates with 200,000 thin slices.
TEST(WavyLevel, CutsACellWhereTheCosineCrossesIt) {
  const SloshingTank tank = waved_tank(7, 0.1);
  const CellBox cell{.left = 0.2, .right = 0.45, .bottom = 0.32, .top = 0.41};
  double filled = 0;
  constexpr int slices = 200000;
  for (int i = 0; i < slices; ++i) {
    const double x = cell.left + (i + 0.5) / slices * (cell.right - cell.left);
    const double height = 0.357 + 0.1 * std::cos(7 * pi * x / 1.1);
    filled += std::clamp((height - cell.bottom) / (cell.top - cell.bottom), 0.0, 1.0) / slices;
  }
  EXPECT_NEAR(share_below_level(tank, cell), filled, 1e-9);
}

SloshingTank disturbed_tank(unsigned seed) {
  SloshingTank tank = still_tank();  // 20 x 10 cells of 0.055 x 0.13 m, filled to 0.357 m
  tank.start_disturbance = start_disturbance(1e-3 * 0.13, seed);
  return tank;
}

TEST(StartDisturbance, IsOneThingForOneSeedAndAnotherForAnother) {
  std::set<std::pair<int, double>> waves;
  for (unsigned seed = 0; seed < 50; ++seed) {
    const InitialWave wave = start_disturbance(2e-5, seed);
    const InitialWave again = start_disturbance(2e-5, seed);
    EXPECT_EQ(wave.mode, again.mode);
    EXPECT_EQ(wave.amplitude, again.amplitude);
    EXPECT_GE(wave.mode, 1);
    EXPECT_LE(wave.mode, 8);
    EXPECT_GE(std::abs(wave.amplitude), 1e-5);
    EXPECT_LE(std::abs(wave.amplitude), 2e-5);
    waves.insert({wave.mode, wave.amplitude});
  }
  EXPECT_EQ(waves.size(), 50U);
}

TEST(StartDisturbance, MovesTheLevelAndKeepsTheVolume) {
  const SloshingTank still = still_tank(), disturbed = disturbed_tank(3);
  const TankMesh mesh(still);
  double volume = 0, moved = 0;
  for (const Cell cell : mesh.cells()) {
    volume += 0.055 * 0.13 * liquid_share(disturbed, mesh, cell);
    moved = std::max(
        moved, std::abs(liquid_share(disturbed, mesh, cell) - liquid_share(still, mesh, cell)));
  }
  EXPECT_NEAR(volume, 1.1 * 0.357, 1e-14);
  EXPECT_GT(moved, 4e-4);
  EXPECT_LT(moved, 1e-3);
}

TEST(StartDisturbance, ChangesNoTimeStep) {
  for (unsigned seed = 0; seed < 8; ++seed)
    EXPECT_EQ(max_time_step(disturbed_tank(seed)), max_time_step(still_tank()));
}

}  // namespace
}  // namespace slosh::openfoam::initial_liquid_test
