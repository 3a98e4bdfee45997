#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "openfoam_cases/check_tank.hpp"
#include "openfoam_cases/geometry/initial_liquid.hpp"
#include "openfoam_cases/tests/run_fixture.hpp"

namespace slosh::openfoam::wavy_level_test {
namespace {

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

TEST(WavyLevel, IsRefusedWhereTheTankCannotHoldIt) {
  const double nan = std::nan("");
  for (const double amplitude : {0.357, -0.4, 2.0, nan})
    EXPECT_THROW(check_tank(waved_tank(1, amplitude)), std::invalid_argument) << amplitude;
  EXPECT_THROW(check_tank(waved_tank(0, 0.01)), std::invalid_argument);
  SloshingTank dam = waved_tank(1, 0.01), baffled = dam;
  dam.column_width = 0.3;
  baffled.obstacles = {{0.11, 0.33, 0, 0.13}};
  EXPECT_THROW(check_tank(dam), std::invalid_argument);
  EXPECT_THROW(check_tank(baffled), std::invalid_argument);
  EXPECT_NO_THROW(check_tank(waved_tank(1, 0.01)));
}

}  // namespace
}  // namespace slosh::openfoam::wavy_level_test
