// Wall pressure, force, moment, momentum and fields of the installed interFoam, compared with
// statics and mechanics.
#include <gtest/gtest.h>

#include "openfoam_cases/tests/motions.hpp"
#include "openfoam_cases/tests/run_fixture.hpp"

namespace slosh::openfoam::run_loads_test {
namespace {

using RunLoads = RunCase;
using Wall = PressureGauge::Wall;

// The pressure is relative to the gas's mean, so that the gas between the surface and its middle
// adds its weight.
double still_pressure(const SloshingTank& tank, double z) {
  return tank.gravity * (tank.liquid.density * (tank.fill_depth - z) +
                         tank.gas.density * (tank.height - tank.fill_depth) / 2);
}

// [Pa] The half-filled cells, which carry part of the liquid above them, change the gas's mean by
// this.
constexpr double pressure_tolerance = 1;

// With a roll whose angle stays 0 the case computes the moment. The level lies inside a cell, and
// the axis is off the centre line.
TEST_F(RunLoads, OfAStillTankAreThoseOfStatics) {
  SloshingTank tank = still_tank();
  tank.cells_z = 52;
  tank.duration = 0.1;
  tank.snapshot_times = {0.05};
  tank.roll = harmonic_roll(0, 1, 0.3, 1.7);
  tank.pressure_gauges = {{"left", Wall::left, 0.17, 0},
                          {"right", Wall::right, 0.01, 0},
                          {"wide", Wall::right, 0.15, 0.2},
                          {"corner", Wall::bottom, 0, 0},
                          {"bottom", Wall::bottom, 0.7, 0.05}};
  const Harvest result = run(tank);
  for (const PressureGauge& gauge : tank.pressure_gauges) {
    const double expected = still_pressure(tank, gauge.wall == Wall::bottom ? 0 : gauge.position);
    for (const double pressure : result.wall_pressure.at(gauge.name).value) {
      EXPECT_NEAR(pressure, expected, pressure_tolerance) << gauge.name;
    }
  }
  const double weight =
      tank.gravity * tank.length *
      (tank.liquid.density * tank.fill_depth + tank.gas.density * (tank.height - tank.fill_depth));
  for (std::size_t i = 0; i < result.force_x.value.size(); ++i) {
    EXPECT_NEAR(result.force_x.value[i], 0, 1e-5 * weight);
    EXPECT_NEAR(result.force_z.value[i], -weight, 1e-5 * weight);
    EXPECT_NEAR(result.moment.value[i], -(tank.length / 2 - 0.3) * weight, 1e-5 * weight);
  }
  const FieldSnapshot& fields = result.snapshots.at(0);
  EXPECT_NEAR(fields.time, 0.05, 1e-9);
  ASSERT_EQ(fields.liquid_share.size(), 1040u);
  double liquid = 0;
  for (std::size_t cell = 0; cell < 1040; ++cell) {
    liquid += fields.liquid_share[cell] * fields.cell_width * fields.cell_height;
    EXPECT_NEAR(fields.velocity_x[cell], 0, 1e-4);
    EXPECT_NEAR(fields.velocity_z[cell], 0, 1e-4);
    if (fields.liquid_share[cell] == 1) {
      EXPECT_NEAR(fields.pressure[cell], still_pressure(tank, fields.z[cell]), pressure_tolerance);
    }
  }
  EXPECT_NEAR(liquid, tank.length * tank.fill_depth, 1e-9);
}

// Forces by wall are those above the gas's mean pressure. Its own weight makes it lighter by half
// of that at the roof, and adds less than 1 % to the force on a side wall.
TEST_F(RunLoads, OfTheWallsAddUpToThoseOfTheTankAndAreHydrostaticAtRest) {
  SloshingTank tank = still_tank();
  tank.cells_z = 52;
  tank.duration = 0.1;
  tank.loaded_walls = {"left", "right", "bottom", "roof"};
  tank.probes = {{"deep", 0.31, 0.12}, {"wall", 0, 0.02}, {"gas", 0.5, 0.9}};
  const Harvest still = run(tank);
  const double side = tank.liquid.density * tank.gravity * tank.fill_depth * tank.fill_depth / 2;
  EXPECT_NEAR(still.wall_force_x.at("left").value.back(), -side, 0.01 * side);
  EXPECT_NEAR(still.wall_force_x.at("right").value.back(), side, 0.01 * side);
  const double gas_weight =
      tank.gravity * tank.gas.density * tank.length * (tank.height - tank.fill_depth);
  EXPECT_NEAR(still.wall_force_z.at("roof").value.back(), -gas_weight / 2,
              pressure_tolerance * tank.length);
  EXPECT_NEAR(still.pressure.at("deep").value.back(), still_pressure(tank, 0.12),
              pressure_tolerance);
  EXPECT_NEAR(still.pressure.at("wall").value.back(), still_pressure(tank, 0.02),
              pressure_tolerance);
  EXPECT_EQ(still.pressure.at("gas").value.back(), 0);
  EXPECT_NEAR(still.velocity_x.at("deep").value.back(), 0, 1e-4);

  tank = small_tank();
  tank.loaded_walls = {"left", "right", "bottom", "roof"};
  const TemporaryDirectory directory;
  const Harvest moving = run_in(directory, tank);
  for (std::size_t i = 0; i < moving.force_x.time.size(); ++i) {
    double x = 0, z = 0;
    for (const auto& [wall, history] : moving.wall_force_x) x += history.value.at(i);
    for (const auto& [wall, history] : moving.wall_force_z) z += history.value.at(i);
    EXPECT_NEAR(x, moving.force_x.value[i], 1e-6 * side);
    EXPECT_NEAR(z, moving.force_z.value[i], 1e-6 * side);
  }
}

// The liquid starts with the tank's velocity. Its momentum then changes by the force of the walls
// and its weight, which is Newton's second law and relates the momentum to the forces. The gas's
// part of the forces is 0.3 % here.
TEST_F(RunLoads, ChangeTheMomentum) {
  SloshingTank tank = small_tank();
  tank.initial_relative_velocity = 0;
  tank.gauges = {};
  tank.velocity = [](double t) { return 0.2 * std::cos(3 * t); };
  tank.acceleration = [](double t) { return -0.6 * std::sin(3 * t); };
  const Harvest result = run(tank);
  const double mass = tank.liquid.density * tank.length * tank.fill_depth;
  const double gas_weight =
      tank.gravity * tank.gas.density * tank.length * (tank.height - tank.fill_depth);
  EXPECT_NEAR(result.momentum_x.value[0], mass * 0.2, 1e-3 * mass * 0.2);
  // The series end at the same sample; the force leaves out the first ones.
  const std::size_t dropped = result.momentum_x.time.size() - result.force_x.time.size();
  double mx = result.momentum_x.value[dropped], mz = result.momentum_z.value[dropped];
  for (std::size_t i = 1; i < result.force_x.time.size(); ++i) {
    const double dt = result.force_x.time[i] - result.force_x.time[i - 1];
    mx -= dt * (result.force_x.value[i] + result.force_x.value[i - 1]) / 2;
    mz -= dt * ((result.force_z.value[i] + result.force_z.value[i - 1]) / 2 + mass * tank.gravity +
                gas_weight);
    EXPECT_NEAR(mx, result.momentum_x.value[i + dropped], 0.01 * mass * 0.2) << i;
    EXPECT_NEAR(mz, result.momentum_z.value[i + dropped], 0.1 * 1.78) << i;  // 0.1 of the largest
  }
}

}  // namespace
}  // namespace slosh::openfoam::run_loads_test
