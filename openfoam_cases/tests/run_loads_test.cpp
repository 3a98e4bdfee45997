// Loads of the installed interFoam, and tanks with obstacles in it.
#include <gtest/gtest.h>

#include <regex>

#include "openfoam_cases/output/harvest.hpp"
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
  tank.loaded_walls = {"left", "right", "bottom", "roof"};
  tank.probes = {{"deep", 0.31, 0.12}, {"wall", 0, 0.02}, {"gas", 0.5, 0.9}};
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
  // Forces by wall are those above the gas's mean pressure. Its own weight makes it lighter by half
  // of that at the roof, and adds less than 1 % to the force on a side wall.
  const double side = tank.liquid.density * tank.gravity * tank.fill_depth * tank.fill_depth / 2;
  EXPECT_NEAR(result.wall_force_x.at("left").value.back(), -side, 0.01 * side);
  EXPECT_NEAR(result.wall_force_x.at("right").value.back(), side, 0.01 * side);
  const double gas_weight =
      tank.gravity * tank.gas.density * tank.length * (tank.height - tank.fill_depth);
  EXPECT_NEAR(result.wall_force_z.at("roof").value.back(), -gas_weight / 2,
              pressure_tolerance * tank.length);
  for (const auto& [probe, z] : {std::pair{"deep", 0.12}, {"wall", 0.02}})
    EXPECT_NEAR(result.pressure.at(probe).value.back(), still_pressure(tank, z),
                pressure_tolerance);
  EXPECT_EQ(result.pressure.at("gas").value.back(), 0);
  EXPECT_NEAR(result.velocity_x.at("deep").value.back(), 0, 1e-4);
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

// Tanks with obstacles in the installed interFoam.

using RunObstacles = RunCase;

// Returns the largest velocity component [m/s] in a time directory.
double largest_velocity(const std::filesystem::path& time_directory) {
  std::string field = contents(time_directory / "U");
  field = field.substr(0, field.find("boundaryField"));
  if (field.find("nonuniform") == field.npos) return NAN;
  field = field.substr(field.find("nonuniform"));
  const std::regex vector(R"(\((\S+) (\S+) (\S+)\))");
  double largest = 0;
  for (std::sregex_iterator at(field.begin(), field.end(), vector), none; at != none; ++at) {
    for (const int i : {1, 2, 3}) largest = std::max(largest, std::abs(std::stod((*at)[i])));
  }
  return largest;
}

// The obstacles are a step in the corner, a submerged one, two that touch at a corner, one that
// pierces the surface and one that hangs from the roof.
SloshingTank crowded_tank() {
  SloshingTank tank = still_tank();
  tank.length = 1;
  tank.height = 0.5;
  tank.fill_depth = 0.23;  // not on a face of a cell
  tank.cells_x = 40;
  tank.cells_z = 20;
  tank.obstacles = {{0, 0.1, 0, 0.15},      {0.2, 0.3, 0.05, 0.1}, {0.4, 0.45, 0, 0.05},
                    {0.45, 0.5, 0.05, 0.1}, {0.6, 0.7, 0.15, 0.3}, {0.9, 1, 0.2, 0.5}};
  tank.gauges = {{"step", 0.05}, {"submerged", 0.25}, {"corner", 0.46}, {"free", 0.55}};
  return tank;
}

// A net force at rest would mean that the force leaves out an obstacle's wall; that of the left
// step alone carries 230 N/m.
TEST_F(RunObstacles, LeaveStillLiquidStill) {
  const SloshingTank tank = crowded_tank();
  const Harvest result = run(tank);
  EXPECT_EQ(result.cells, 800 - 24 - 8 - 4 - 4 - 24 - 48);
  for (const double volume : result.liquid_volume.value) {
    EXPECT_NEAR(volume / result.liquid_volume.value[0], 1, 1e-10);
  }
  for (const auto& [gauge, elevation] : result.elevation) {
    for (const double value : elevation.value) EXPECT_NEAR(value, 0, 1e-6) << gauge;
  }
  for (const double force : result.force_x.value) EXPECT_NEAR(force, 0, 0.01);
  EXPECT_LT(largest_velocity(directory_.path() / "1"), 1e-4);
}

// The mirrored tank in the mirrored motion must give the mirrored result. A cell in a wrong place
// or an obstacle's wall left out of the force would break the symmetry.
TEST_F(RunObstacles, GiveTheSameTurnedRound) {
  SloshingTank tank = small_tank();
  tank.duration = 0.3;
  tank.obstacles = {{0.11, 0.22, 0, 0.26}, {0.99, 1.1, 0.39, 0.52}};
  tank.gauges = {{"beside", 0.05}, {"over", 0.17}, {"middle", 0.5}};
  const Harvest result = run(tank);
  const auto acceleration = tank.acceleration;
  tank.acceleration = [=](double time) { return -acceleration(time); };
  tank.initial_relative_velocity *= -1;
  for (Gauge& gauge : tank.gauges) gauge.x = tank.length - gauge.x;
  for (Obstacle& obstacle : tank.obstacles) {
    obstacle = {tank.length - obstacle.right, tank.length - obstacle.left, obstacle.bottom,
                obstacle.top};
  }
  const Harvest turned = run_in(TemporaryDirectory(), tank);
  for (const auto& [gauge, elevation] : result.elevation) {
    double highest = 0;
    for (std::size_t i = 0; i < elevation.value.size(); ++i) {
      highest = std::max(highest, std::abs(elevation.value[i]));
      EXPECT_NEAR(elevation.value[i], turned.elevation.at(gauge).value.at(i), 1e-6) << gauge;
    }
    EXPECT_GT(highest, 1e-3) << gauge;
  }
  const History& force = result.force_x;
  for (std::size_t i = 0; i < force.value.size(); ++i) {
    EXPECT_NEAR(force.value[i], -turned.force_x.value.at(i), 0.01);
  }
}

}  // namespace
}  // namespace slosh::openfoam::run_loads_test
