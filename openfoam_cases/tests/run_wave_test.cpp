// Free waves and a dam break in the installed interFoam.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "openfoam_cases/output/harvest.hpp"
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
  tank.cells_z = 30;
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

// Returns the rms of the elevation over two periods, from the first one on or from the third.
double rms(const History& elevation, double period, bool later) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < elevation.time.size(); ++i) {
    const double periods = elevation.time[i] / period;
    if (periods > (later ? 4 : 2) || periods < (later ? 2 : 0)) continue;
    sum += elevation.value[i] * elevation.value[i];
    ++count;
  }
  return std::sqrt(sum / count);
}

// A free wave of four periods in a tank whose gap walls may cause friction.
struct FreeWave {
  SloshingTank tank = still_tank();
  double period;

  explicit FreeWave(double gap_friction) {
    tank.length = 1;
    tank.height = 1;
    tank.fill_depth = 0.5;
    tank.initial_wave = InitialWave{1, 0.02};
    tank.gauges = {{"left", 0.05}};
    tank.cells_x = 20;
    tank.cells_z = 40;
    tank.gap_friction = gap_friction;
    const double k = std::numbers::pi / tank.length;
    period = 2 * std::numbers::pi / std::sqrt(tank.gravity * k * std::tanh(k * tank.fill_depth));
    tank.duration = std::ceil(4 * period / tank.sample_interval) * tank.sample_interval;
  }
};

// Returns the largest difference of the momentum from the walls' impulse on the liquid since the
// first force [N s/m].
double largest_unbalanced_impulse(const Harvest& result) {
  const std::size_t dropped = result.momentum_x.time.size() - result.force_x.time.size();
  const History& force = result.force_x;
  double impulse = result.momentum_x.value[dropped], largest = 0;
  for (std::size_t i = 1; i < force.time.size(); ++i) {
    impulse -= 0.5 * (force.value[i - 1] + force.value[i]) * (force.time[i] - force.time[i - 1]);
    largest = std::max(largest, std::abs(impulse - result.momentum_x.value[i + dropped]));
  }
  return largest;
}

// Of the energy, half is kinetic: an amplitude decays at half the rate of a velocity. The mesh's
// own damping is the same without the friction. Measured: 1.02 times that.
TEST_F(RunCase, DampsAWaveAtHalfTheRateOfTheFrontAndBackWallsFriction) {
  constexpr double rate = 0.5;
  const FreeWave free(0), slowed(rate);
  const Harvest without = run_in(TemporaryDirectory(), free.tank), with = run(slowed.tank);
  const auto remaining = [&](const Harvest& result) {
    const History& left = result.elevation.at("left");
    return rms(left, free.period, true) / rms(left, free.period, false);
  };
  const double more = std::log(remaining(without) / remaining(with)) / (2 * free.period);
  EXPECT_NEAR(more, 0.5 * rate, 0.05 * 0.5 * rate);
  // The recorded force is that of all walls, so that it balances the momentum. Measured: to 1.2 %
  // with the friction, and to 1.3 % without.
  const std::vector<double>& momentum = with.momentum_x.value;
  const double largest = *std::max_element(momentum.begin(), momentum.end());
  EXPECT_LE(largest_unbalanced_impulse(with), 0.02 * largest);
}

// A dam break in the installed interFoam.

// The column of Martin & Moyce 1952, figure 3, is 2.25 in wide and twice as high, in a tank that
// the front crosses during the run.
SloshingTank dam() {
  constexpr double width = 0.05715;
  SloshingTank tank = still_tank();
  tank.length = 6 * width;
  tank.height = 3 * width;
  tank.fill_depth = 2 * width;
  tank.column_width = width;
  tank.duration = 0.25;
  tank.gauges = {{"column", 0.5 * width}, {"dry", 4 * width}};
  tank.cells_x = 60;
  tank.cells_z = 30;
  return tank;
}

double value_at(const History& history, double time) {
  const auto after = std::lower_bound(history.time.begin(), history.time.end(), time);
  const auto i = std::max<std::ptrdiff_t>(after - history.time.begin(), 1);
  return std::lerp(history.value[i - 1], history.value[i],
                   (time - history.time[i - 1]) / (history.time[i] - history.time[i - 1]));
}

using RunColumn = RunCase;

TEST_F(RunColumn, KeepsItsVolumeFromTheFirstStepOn) {
  SloshingTank tank = dam();
  tank.column_width = 0.0591, tank.fill_depth = 0.1103;  // not on faces of cells
  tank.duration = 0.03;
  const Harvest result = run(tank);
  for (const double volume : result.liquid_volume.value) {
    EXPECT_NEAR(volume / (0.0591 * 0.1103), 1, 1e-9);
  }
}

// An ideal front moves along a dry bottom at 2 sqrt(g h) from the start (Ritter 1892). A real front
// does not, since a column must first convert its fall into speed. The experiment's front is late
// by 0.27 of its unit of time, 14 ms, at all three points, as with a diaphragm that takes time to
// open. The test therefore compares the speed, which is 4 % higher here (5 % at 120 x 60), with
// free slip on the walls.
TEST_F(RunColumn, RunsItsFrontBetweenTheExperimentsAndTheIdealOne) {
  const SloshingTank tank = dam();
  const double width = *tank.column_width;
  const Harvest result = run(tank);
  const History& front = result.front_position;
  ASSERT_EQ(front.time.size(), 26u);
  EXPECT_NEAR(front.value[0], width, 1e-15);
  for (std::size_t i = 1; i < front.time.size(); ++i) {
    EXPECT_GE(front.value[i], front.value[i - 1] - 1e-3 * width) << front.time[i];
    EXPECT_LE(front.value[i], width + 2 * std::sqrt(9.81 * tank.fill_depth) * front.time[i]);
  }
  EXPECT_NEAR(front.value.back(), tank.length, 0.01 * tank.length);
  // t sqrt(2 g / a) and x / a as PySPH (db_exp_data.py) digitised the figure.
  const std::array<std::array<double, 2>, 3> experiment{
      {{1.997, 2.292}, {2.547, 2.995}, {3.345, 4.134}}};
  std::array<double, 3> found;
  for (std::size_t i = 0; i < experiment.size(); ++i) {
    const double time = experiment[i][0] / std::sqrt(2 * tank.gravity / width);
    found[i] = value_at(front, time) / width;
    EXPECT_GT(found[i], experiment[i][1]);
    EXPECT_LT(found[i], 1.2 * experiment[i][1]);
  }
  EXPECT_NEAR((found[2] - found[0]) / (experiment[2][1] - experiment[0][1]), 1, 0.07);
  EXPECT_EQ(result.elevation.at("column").value[0], 0);
  EXPECT_LT(result.elevation.at("column").value.back(), -0.5 * tank.fill_depth);
  EXPECT_EQ(result.elevation.at("dry").value[0], -tank.fill_depth);
  EXPECT_GT(result.elevation.at("dry").value.back(), -tank.fill_depth);
}

}  // namespace
}  // namespace slosh::openfoam::run_wave_test
