// Free waves in the installed interFoam: their release from rest and their viscous damping.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "openfoam_cases/tests/run_fixture.hpp"

namespace slosh::openfoam::run_wave_test {
namespace {

// For H = 1, g = 1, k = pi and nu = 1/50 these are eta(t)/eta(0) at t = 1, 2 and 4 from the
// complete solution of the linear Navier-Stokes equations (Prosperetti 1981 in finite depth).
TEST_F(RunCase, DampsAWaveByTheLiquidsViscosity) {
  SloshingTank tank = still_tank();
  tank.length = 1;
  tank.height = 1.5;
  tank.fill_depth = 1;
  tank.gravity = 1;
  tank.liquid = {.density = 1000, .kinematic_viscosity = 0.02};
  tank.gas = {.density = 0.1, .kinematic_viscosity = 1.5e-5};
  tank.initial_wave = InitialWave{1, 0.02};
  tank.gauges = {{"left", 0.05}};
  tank.duration = 4;
  tank.sample_interval = 0.02;
  tank.cells_x = 20;
  tank.cells_z = 60;
  const Harvest result = run(tank);
  EXPECT_LT(std::abs(result.relative_mass_loss), 1e-9);
  const History& left = result.elevation.at("left");
  ASSERT_EQ(left.time.size(), 201u);
  const double start = 0.02 * std::cos(0.05 * std::numbers::pi);
  // The gauge lies between two columns, whose means flatten the cosine by 0.4 %.
  EXPECT_NEAR(left.value[0], start, 0.006 * start);
  EXPECT_NEAR(left.value[50] / start, 0.0070, 0.02);
  EXPECT_NEAR(left.value[100] / start, -0.5932, 0.02);
  EXPECT_NEAR(left.value[200] / start, 0.3051, 0.02);
}

}  // namespace
}  // namespace slosh::openfoam::run_wave_test
