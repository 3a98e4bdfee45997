#include "sph/terms/equation_of_state.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slosh::sph {
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

}  // namespace
}  // namespace slosh::sph
