// Walls to which the liquid sticks, and cells that are graded towards the walls, in the installed
// interFoam.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "openfoam_cases/tests/run_fixture.hpp"

namespace slosh::openfoam::run_walls_test {
namespace {

using RunWalls = RunCase;
using std::numbers::pi;

TEST_F(RunWalls, LeaveStillLiquidAtItsLevelUnderItsHydrostaticPressureInGradedCells) {
  SloshingTank tank = still_tank();
  tank.cells_x = 30;
  tank.cells_z = 26;
  tank.wall_cell = 0.015;
  tank.no_slip = true;
  tank.duration = 0.5;
  tank.gauges = {{"left", 0.004}, {"middle", 0.55}, {"right", 1.1}};
  tank.pressure_gauges = {{"corner", PressureGauge::Wall::left, 0.003, 0},
                          {"wide", PressureGauge::Wall::left, 0.15, 0.2},
                          {"bottom", PressureGauge::Wall::bottom, 0.3, 0}};
  tank.loaded_walls = {"left", "bottom"};
  tank.snapshot_times = {0.4};
  const Harvest result = run(tank);
  EXPECT_EQ(result.cells, 30 * 26);
  for (const auto& [gauge, elevation] : result.elevation)
    for (const double value : elevation.value) EXPECT_NEAR(value, 0, 1e-7) << gauge;
  // Between centres of cells the gas's density gives the pressure 0.1 Pa more.
  const double weight = (tank.liquid.density - tank.gas.density) * tank.gravity;
  const auto expect_hydrostatic = [&](const char* gauge, double z) {
    EXPECT_NEAR(result.wall_pressure.at(gauge).value.back(), weight * (tank.fill_depth - z),
                0.01 * weight * tank.fill_depth)
        << gauge;
  };
  expect_hydrostatic("corner", 0.003);
  expect_hydrostatic("wide", 0.15);
  expect_hydrostatic("bottom", 0);
  const double difference =
      result.wall_pressure.at("corner").value.back() - result.wall_pressure.at("wide").value.back();
  EXPECT_NEAR(difference, tank.liquid.density * tank.gravity * 0.147, 0.1);
  EXPECT_NEAR(result.wall_force_z.at("bottom").value.back(),
              -weight * tank.fill_depth * tank.length, 0.01 * weight * tank.fill_depth);
  const FieldSnapshot& fields = result.snapshots.at(0);
  double liquid = 0;
  for (std::size_t i = 0; i < fields.x.size(); ++i)
    liquid += fields.area[i] * fields.liquid_share[i];
  EXPECT_NEAR(liquid, tank.length * tank.fill_depth, 1e-9);
}

// A standing wave in a shallow viscous liquid.
struct ShallowWave {
  SloshingTank tank = still_tank();
  double k = pi, frequency, layer;  // 1/m, rad/s, thickness of the Stokes layer [m]

  explicit ShallowWave(bool no_slip) {
    tank.length = 1;
    tank.height = 0.2;
    tank.fill_depth = 0.1;
    tank.liquid.kinematic_viscosity = 5e-5;
    tank.initial_wave = InitialWave{1, 0.004};
    tank.gauges = {{"left", 0.05}};
    tank.cells_x = 46;
    tank.cells_z = 28;
    tank.wall_cell = 0.002;
    tank.no_slip = no_slip;
    frequency = std::sqrt(tank.gravity * k * std::tanh(k * tank.fill_depth));
    layer = std::sqrt(2 * tank.liquid.kinematic_viscosity / frequency);
    tank.duration = std::ceil(4 * period() / tank.sample_interval) * tank.sample_interval;
  }

  double period() const { return 2 * pi / frequency; }

  // The amplitude's rate of decay [1/s] by the dissipation in the Stokes layers of the bottom and
  // the two end walls, D = rho U^2 nu / (2 layer) per area for a velocity of the amplitude U
  // outside the layer (Landau and Lifshitz 1987, Fluid Mechanics, section 24), over twice the
  // wave's energy rho g A^2 L / 4 (Keulegan 1959, J. Fluid Mech. 6:33).
  double expected_rate() const {
    const double twice = 2 * k * tank.fill_depth;
    return tank.liquid.kinematic_viscosity * k / layer *
           (1 / std::sinh(twice) + (1 - twice / std::sinh(twice)) / (k * tank.length));
  }
};

// Returns the amplitude's rate of decay from the rms over the first two periods and the next two.
double rate_of(const History& elevation, double period) {
  double early = 0, late = 0;
  int counts[2] = {};
  for (std::size_t i = 0; i < elevation.time.size(); ++i) {
    const double periods = elevation.time[i] / period;
    if (periods >= 4) break;
    (periods < 2 ? early : late) += std::pow(elevation.value[i], 2);
    ++counts[periods < 2 ? 0 : 1];
  }
  return std::log(early / counts[0] / (late / counts[1])) / (4 * period);
}

// The mesh's own damping and that inside the liquid are the same with slip. The theory's own error
// is the layer's share of the depth, 0.06. Measured: 1.07 times theory with wall cells of 1.5 mm in
// 60 x 40 cells, 1.06 times in these cells. Cells of 2 mm at the walls make it take twelve seconds.
TEST_F(RunWalls, DampAWaveByTheirStokesLayers) {
  const ShallowWave slipping(false), sticking(true);
  const Harvest without = run_in(TemporaryDirectory(), slipping.tank), with = run(sticking.tank);
  const double period = sticking.period();
  const double rate =
      rate_of(with.elevation.at("left"), period) - rate_of(without.elevation.at("left"), period);
  EXPECT_NEAR(rate / sticking.expected_rate(), 1, 0.12);
}

}  // namespace
}  // namespace slosh::openfoam::run_walls_test
