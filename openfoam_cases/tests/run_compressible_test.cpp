// compressibleInterFoam against interFoam where neither fluid is compressed, and against the law of
// the gas where it is.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "openfoam_cases/compressible_fluids.hpp"
#include "openfoam_cases/tests/motions.hpp"
#include "openfoam_cases/tests/outlines.hpp"
#include "openfoam_cases/tests/run_fixture.hpp"

namespace slosh::openfoam::run_compressible_test {
namespace {

using RunCompressible = RunCase;

SloshingTank compressible(SloshingTank tank) {
  tank.program = Program::compressible_inter_foam;
  return tank;
}

// The weight of the liquid compresses it by 8e-7 of its depth of 0.357 m.
TEST_F(RunCompressible, LeavesStillLiquidStillUnderItsHydrostaticPressure) {
  SloshingTank tank = compressible(still_tank());
  tank.duration = 0.3;
  tank.pressure_gauges = {{"low", PressureGauge::Wall::left, 0.1, 0}};
  const Harvest result = run(tank);
  for (const auto& [gauge, elevation] : result.elevation)
    for (const double value : elevation.value) EXPECT_NEAR(value, 0, 1e-6) << gauge;
  EXPECT_LT(std::abs(result.relative_mass_loss), 2e-6);
  const double hydrostatic = tank.liquid.density * tank.gravity * (tank.fill_depth - 0.1);
  // The liquid of the surface cell that is counted to the gas adds 11 Pa, as in interFoam.
  EXPECT_NEAR(result.wall_pressure.at("low").value.back(), hydrostatic, 0.01 * hydrostatic);
  EXPECT_NEAR(result.force_x.value.back(), 0, 0.01);
}

TEST_F(RunCompressible, GivesInterFoamsRollOnTwoProcesses) {
  SloshingTank tank = still_tank();
  tank.roll = harmonic_roll(0.02, 2, 0.55, 0);
  tank.processes = 2;
  const Harvest with = run(compressible(tank)), without = run_in(TemporaryDirectory(), tank);
  const std::vector<double>&a = with.moment.value, &b = without.moment.value;
  ASSERT_EQ(a.size(), b.size());
  const double size = std::abs(b.back());
  for (std::size_t i = a.size() / 2; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 0.01 * size);
}

// A tank that a wall divides down to below the surface: a closed U-tube with a pocket of gas over
// each limb.
SloshingTank closed_u_tube() {
  SloshingTank tank = still_tank();
  tank.length = 1;
  tank.height = 1;
  tank.fill_depth = 0.5;
  tank.cells_x = 20;
  tank.cells_z = 40;
  tank.obstacles = {{0.3, 0.7, 0.2, 1.0}};
  tank.gauges = {{"left", 0.15}, {"right", 0.85}};
  tank.duration = 3;
  return tank;
}

// The tank's acceleration rises from 0 to `last` [m/s2] within two seconds, six periods of the
// pockets' oscillation.
SloshingTank pressed(SloshingTank tank, double last) {
  constexpr double rise = 2;
  const auto share = [=](double t) { return std::min(t / rise, 1.0); };
  tank.acceleration = [=](double t) {
    const double s = share(t);
    return last * s * s * (3 - 2 * s);
  };
  tank.velocity = [](double) { return 0.0; };  // only the momentum needs it
  return tank;
}

// Under a constant acceleration a the liquid rises by d in the left limb and falls by d in the
// right one. Between the middles of the limbs, a distance s apart, hydrostatics ask for
//   p_left - p_right = rho (a s - 2 g d),   p_left, p_right = p_atm H / (H -+ d)
// with H the height of a pocket at rest, of a gas that keeps its temperature.
double expected_rise(const SloshingTank& tank, double acceleration) {
  const double H = 0.5, s = 0.7, rho = tank.liquid.density - tank.gas.density;
  double d = 0;
  for (int i = 0; i < 50; ++i) {
    const double stiffness = 2 * atmosphere * H / (H * H - d * d) + 2 * rho * tank.gravity;
    d = rho * acceleration * s / stiffness;
  }
  return d;
}

TEST_F(RunCompressible, CompressesATrappedPocketOfGasByBoylesLaw) {
  constexpr double acceleration = 4;
  const SloshingTank tank = pressed(closed_u_tube(), acceleration);
  const Harvest result = run(compressible(tank));
  const double rise = expected_rise(tank, acceleration);
  const auto mean_of_last = [&](const char* gauge) {
    const std::vector<double>& value = result.elevation.at(gauge).value;
    double sum = 0;
    for (std::size_t i = value.size() - 50; i < value.size(); ++i) sum += value[i];
    return sum / 50;
  };
  EXPECT_NEAR(mean_of_last("left"), rise, 0.03 * rise);
  EXPECT_NEAR(mean_of_last("right"), -rise, 0.03 * rise);
  const Harvest incompressible = run_in(TemporaryDirectory(), tank);
  for (const double value : incompressible.elevation.at("left").value)
    EXPECT_NEAR(value, 0, 0.1 * rise) << "interFoam's gas gives no way";
}

TEST_F(RunCompressible, LeavesLiquidStillInATankWithAnOutline) {
  SloshingTank tank = compressible(chamfered_tank());
  tank.duration = 0.1;
  for (const auto& [gauge, elevation] : run(tank).elevation)
    for (const double value : elevation.value) EXPECT_NEAR(value, 0, 1e-5) << gauge;
}

}  // namespace
}  // namespace slosh::openfoam::run_compressible_test
