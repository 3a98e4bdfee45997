#include "sph/terms/equation_of_state.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slosh::sph::equation_of_state_test {
namespace {

const Tait water(1000, 20);

TEST(Tait, HasNoPressureAtTheRestDensity) {
  EXPECT_EQ(water.pressure(1000), 0);
  EXPECT_EQ(water.density(0), 1000);
}

TEST(Tait, GivesKnownPressures) {
  // B = 1000 * 400 / 7 Pa; 1.01^7 and 2^7 by hand.
  EXPECT_NEAR(water.pressure(1010), 400000.0 / 7 * 0.0721353521070100, 1e-8);
  EXPECT_NEAR(water.pressure(2000), 400000.0 / 7 * 127, 1e-6);
  EXPECT_LT(water.pressure(999), 0);
}

TEST(Tait, ReturnsTheDensityThatItsPressureCameFrom) {
  for (double density : {900.0, 999.0, 1000.0, 1000.001, 1008.0, 1100.0}) {
    EXPECT_NEAR(water.density(water.pressure(density)), density, 1e-10 * density);
  }
}

TEST(Tait, HasItsSpeedOfSoundAtTheRestDensity) {
  const double slope = (water.pressure(1000.01) - water.pressure(999.99)) / 0.02;
  EXPECT_NEAR(std::sqrt(slope), 20, 1e-6);
}

template <class State>
void expect_the_energy_of_compression(const State& state) {
  EXPECT_EQ(state.energy(1000), 0);
  for (const double density : {600.0, 990.0, 1001.0, 1005.0, 1080.0}) {
    const double step = 1e-3;
    const double slope = (state.energy(density + step) - state.energy(density - step)) / (2 * step);
    const double expected = state.pressure(density) / (density * density);
    EXPECT_NEAR(slope, expected, 1e-7 * std::abs(expected)) << density;
  }
  // To second order, c0^2 / 2 (rho / rho_0 - 1)^2, with every digit that this leaves.
  EXPECT_NEAR(state.energy(1000 * (1 + 1e-7)) / (200 * 1e-14), 1, 1e-6);
}

TEST(Energy, IsZeroAtRestAndGrowsByThePressureOverTheDensitySquared) {
  expect_the_energy_of_compression(water);
  Setting setting{};
  setting.rest_density = 1000;
  setting.speed_of_sound = 20;
  expect_the_energy_of_compression(LinearState(setting));
  expect_the_energy_of_compression(CubicState(setting));
  expect_the_energy_of_compression(QuinticState(setting));
}

TEST(PowerLawStates, AreThatPower) {
  EXPECT_NEAR(CubicState(1000, 20).pressure(1010), 400000.0 / 3 * 0.030301, 1e-8);
  EXPECT_NEAR(QuinticState(1000, 20).pressure(1010), 400000.0 / 5 * 0.0510100501, 1e-8);
  EXPECT_NEAR(CubicState(1000, 20).density(400000.0 / 3 * 7), 2000, 1e-9);
}

}  // namespace
}  // namespace slosh::sph::equation_of_state_test
