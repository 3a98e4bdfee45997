#include "openfoam_cases/time_step.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "openfoam_cases/tests/small_tank.hpp"

namespace slosh::openfoam::time_step_test {
namespace {

TEST(TimeStep, IsAHundredthOfTheFirstModesInverseFrequencyOrOfTheWavesOwn) {
  SloshingTank tank = still_tank();
  const auto omega = [&](int mode) {
    const double k = mode * std::numbers::pi / tank.length;
    return std::sqrt(tank.gravity * k * std::tanh(k * tank.fill_depth));
  };
  EXPECT_DOUBLE_EQ(max_time_step(tank), 0.01 / omega(1));
  tank.initial_wave = InitialWave{3, 0.01};
  EXPECT_DOUBLE_EQ(max_time_step(tank), 0.01 / omega(3));
}

// After n corrections the error is reduced by (d / (1 + d))^n, d = 2 nu dt (1/dx^2 + 1/dz^2).
TEST(PressureCorrections, AreTwoOfWaterAndMoreTheMoreViscousTheLiquidIs) {
  SloshingTank tank = still_tank();
  EXPECT_EQ(pressure_corrections(tank), 2);
  tank.liquid.kinematic_viscosity = 0;
  EXPECT_EQ(pressure_corrections(tank), 2);
  const double per_length = tank.cells_x / tank.length, per_height = tank.cells_z / tank.height;
  const double unit =
      1 / (2 * max_time_step(tank) * (per_length * per_length + per_height * per_height));  // d = 1
  tank.liquid.kinematic_viscosity = unit;
  EXPECT_EQ(pressure_corrections(tank), 9);  // 2^-9 < 0.002 < 2^-8
  tank.liquid.kinematic_viscosity = unit / 9;
  EXPECT_EQ(pressure_corrections(tank), 3);  // 0.1^3 < 0.002 < 0.1^2
}

}  // namespace
}  // namespace slosh::openfoam::time_step_test
