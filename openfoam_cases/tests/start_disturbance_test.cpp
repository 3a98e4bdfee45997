#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include "openfoam_cases/check_tank.hpp"
#include "openfoam_cases/geometry/initial_liquid.hpp"
#include "openfoam_cases/tests/run_fixture.hpp"
#include "openfoam_cases/time_step.hpp"

namespace slosh::openfoam::start_disturbance_test {
namespace {

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

TEST(StartDisturbance, IsRefusedWhereTheLevelIsNoPlainOne) {
  SloshingTank dam = disturbed_tank(1), waved = disturbed_tank(1), baffled = disturbed_tank(1);
  dam.column_width = 0.3;
  waved.initial_wave = InitialWave{1, 0.01};
  baffled.obstacles = {{0.11, 0.33, 0, 0.13}};
  for (const SloshingTank& tank : {dam, waved, baffled})
    EXPECT_THROW(check_tank(tank), std::invalid_argument);
  EXPECT_NO_THROW(check_tank(disturbed_tank(1)));
}

}  // namespace
}  // namespace slosh::openfoam::start_disturbance_test
