#include "verification/case/gap_friction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace slosh::gap_friction_test {
namespace {

constexpr double gap = 0.062;

// Returns the viscosity for which a Stokes layer has this share of the gap.
double viscosity_of_layer(double share, double omega) {
  return 0.5 * omega * share * share * gap * gap;
}

TEST(FrictionBetweenWalls, IsThatOfPoiseuilleFlowWhereTheLayersFillTheGap) {
  for (const double share : {2.0, 20.0, 2000.0}) {
    const double nu = viscosity_of_layer(share, 4), expected = 12 * nu / (gap * gap);
    EXPECT_NEAR(friction_between_walls(gap, nu, 4), expected, 1e-4 * expected) << share;
  }
  EXPECT_DOUBLE_EQ(friction_between_walls(gap, 5e-5, 0), 12 * 5e-5 / (gap * gap));
}

TEST(FrictionBetweenWalls, IsThatOfTwoStokesLayersWhereTheyAreThin) {
  for (const double share : {0.05, 0.01, 1e-4}) {
    const double nu = viscosity_of_layer(share, 4),
                 expected = 2 / gap * std::sqrt(0.5 * nu * 4) + 4 * nu / (gap * gap);
    EXPECT_NEAR(friction_between_walls(gap, nu, 4), expected, 0.006 * expected) << share;
  }
}

// The series for a thin gap is used below |kappa| = 1e-3.
TEST(FrictionBetweenWalls, HasNoJumpBetweenItsSeriesAndItsFormula) {
  const double nu = 1e-2, omega = 4 * nu * 1e-6 / (gap * gap);
  EXPECT_NEAR(
      friction_between_walls(gap, nu, 1.01 * omega) / friction_between_walls(gap, nu, 0.99 * omega),
      1, 1e-8);
}

// The oil of 5e-5 m2/s in a tank 62 mm broad, at 4 rad/s: the formula evaluated on its own.
TEST(FrictionBetweenWalls, OfAnOilIsAThirdOfASecond) {
  EXPECT_NEAR(friction_between_walls(gap, 5e-5, 4), 0.378738, 1e-6);
  EXPECT_EQ(friction_between_walls(gap, 0, 4), 0);
}

CaseDefinition narrow_tank() {
  CaseDefinition definition{};
  definition.gravity = 9.81;
  definition.tank = {.length = 0.9, .height = 0.5, .breadth = gap};
  definition.liquid = {.fill_depth = 0.1, .density = 900, .kinematic_viscosity = 5e-5};
  return definition;
}

double natural_frequency(int mode) {
  const double k = mode * std::numbers::pi / 0.9;
  return std::sqrt(9.81 * k * std::tanh(0.1 * k));
}

TEST(GapFriction, TakesTheForcingsFrequencyOrANaturalOne) {
  CaseDefinition definition = narrow_tank();
  EXPECT_DOUBLE_EQ(gap_friction(definition),
                   friction_between_walls(gap, 5e-5, natural_frequency(1)));
  definition.initial_wave = InitialWaveDefinition{3, 0.01};
  EXPECT_DOUBLE_EQ(gap_friction(definition),
                   friction_between_walls(gap, 5e-5, natural_frequency(3)));
  definition.motion.roll = RollDefinition{SineMotion{0.07, 3.8}, 0.45, 0};
  EXPECT_DOUBLE_EQ(gap_friction(definition), friction_between_walls(gap, 5e-5, 3.8));
  definition.motion.roll->angle = TableMotion{};
  definition.declared_forcing_frequency = 4.2;
  EXPECT_DOUBLE_EQ(gap_friction(definition), friction_between_walls(gap, 5e-5, 4.2));
}

TEST(GapFriction, IsZeroWithoutABreadth) {
  CaseDefinition definition = narrow_tank();
  definition.tank.breadth.reset();
  EXPECT_EQ(gap_friction(definition), 0);
}

}  // namespace
}  // namespace slosh::gap_friction_test
