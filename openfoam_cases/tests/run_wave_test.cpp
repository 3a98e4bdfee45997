// Free waves in the installed interFoam: their release from rest and their viscous damping.
#include <gtest/gtest.h>

#include <algorithm>
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

}  // namespace
}  // namespace slosh::openfoam::run_wave_test
