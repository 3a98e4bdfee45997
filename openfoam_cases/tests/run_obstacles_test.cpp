// Tanks with obstacles in the installed interFoam.
#include <gtest/gtest.h>

#include <regex>

#include "openfoam_cases/output/harvest.hpp"
#include "openfoam_cases/tests/run_fixture.hpp"

namespace slosh::openfoam::run_obstacles_test {
namespace {

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
  tank.duration = 0.4;
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
  TemporaryDirectory turned_directory;
  const Harvest turned = run_in(turned_directory, tank);
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

// The run is short, because processes that wait for each other are slow on busy cores. The
// processes' domains meet inside the obstacle.
TEST_F(RunObstacles, GiveTheSameOnTwoProcessesAsOnOne) {
  SloshingTank tank = still_tank();
  tank.duration = 0.05;
  tank.column_width = 0.42;
  tank.obstacles = {{0.495, 0.605, 0, 0.26}};
  const Harvest serial = run(tank);
  tank.processes = 2;
  TemporaryDirectory parallel_directory;
  const Harvest parallel = run_in(parallel_directory, tank);
  ASSERT_EQ(serial.front_position.time.size(), 6u);
  EXPECT_GT(serial.front_position.value.back(), 0.43);
  for (std::size_t i = 0; i < serial.front_position.time.size(); ++i) {
    EXPECT_NEAR(serial.front_position.value[i], parallel.front_position.value.at(i), 1e-6);
    EXPECT_NEAR(serial.liquid_volume.value[i], parallel.liquid_volume.value.at(i), 1e-12);
  }
}

}  // namespace
}  // namespace slosh::openfoam::run_obstacles_test
