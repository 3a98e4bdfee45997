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

TEST(LayersBetweenWalls, IsThatOfPoiseuilleFlowWhereTheLayersFillTheGap) {
  for (const double share : {2.0, 20.0, 2000.0}) {
    const double nu = viscosity_of_layer(share, 4), expected = 12 * nu / (gap * gap);
    EXPECT_NEAR(layers_between_walls(gap, nu, 4).friction, expected, 1e-4 * expected) << share;
  }
  EXPECT_DOUBLE_EQ(layers_between_walls(gap, 5e-5, 0).friction, 12 * 5e-5 / (gap * gap));
}

// The mean inertia of a parabolic profile is 6/5 of that of a uniform one.
TEST(LayersBetweenWalls, AddAFifthOfTheInertiaWhereTheyFillTheGap) {
  for (const double share : {2.0, 20.0, 2000.0})
    EXPECT_NEAR(layers_between_walls(gap, viscosity_of_layer(share, 4), 4).added_mass, 0.2, 1e-4)
        << share;
  EXPECT_DOUBLE_EQ(layers_between_walls(gap, 5e-5, 0).added_mass, 0.2);
}

TEST(LayersBetweenWalls, AddTheMassOfHalfALayerOnEachWallWhereTheyAreThin) {
  for (const double share : {0.01, 1e-3, 1e-4})
    EXPECT_NEAR(layers_between_walls(gap, viscosity_of_layer(share, 4), 4).added_mass, share,
                0.02 * share)
        << share;
}

TEST(LayersBetweenWalls, IsThatOfTwoStokesLayersWhereTheyAreThin) {
  for (const double share : {0.05, 0.01, 1e-4}) {
    const double nu = viscosity_of_layer(share, 4),
                 expected = 2 / gap * std::sqrt(0.5 * nu * 4) + 4 * nu / (gap * gap);
    EXPECT_NEAR(layers_between_walls(gap, nu, 4).friction, expected, 0.006 * expected) << share;
  }
}

// The series for a thin gap is used below |kappa| = 0.1.
TEST(LayersBetweenWalls, HasNoJumpBetweenItsSeriesAndItsFormula) {
  const double nu = 1e-2, omega = 4 * nu * 0.01 / (gap * gap);
  const WallLayers above = layers_between_walls(gap, nu, 1.01 * omega),
                   below = layers_between_walls(gap, nu, 0.99 * omega);
  EXPECT_NEAR(above.friction / below.friction, 1, 1e-8);
  EXPECT_NEAR(above.added_mass / below.added_mass, 1, 1e-6);
}

// The oil of 5e-5 m2/s in a tank 62 mm broad, at 4 rad/s: the formula evaluated on its own.
TEST(LayersBetweenWalls, OfAnOilIsAThirdOfASecond) {
  EXPECT_NEAR(layers_between_walls(gap, 5e-5, 4).friction, 0.378738, 1e-6);
  EXPECT_EQ(layers_between_walls(gap, 0, 4).friction, 0);
  EXPECT_EQ(layers_between_walls(gap, 0, 4).added_mass, 0);
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
                   layers_between_walls(gap, 5e-5, natural_frequency(1)).friction);
  definition.initial_wave = InitialWaveDefinition{3, 0.01};
  EXPECT_DOUBLE_EQ(gap_friction(definition),
                   layers_between_walls(gap, 5e-5, natural_frequency(3)).friction);
  definition.motion.roll = RollDefinition{SineMotion{0.07, 3.8}, 0.45, 0};
  EXPECT_DOUBLE_EQ(gap_friction(definition), layers_between_walls(gap, 5e-5, 3.8).friction);
  definition.motion.roll->angle = TableMotion{};
  definition.declared_forcing_frequency = 4.2;
  EXPECT_DOUBLE_EQ(gap_friction(definition), layers_between_walls(gap, 5e-5, 4.2).friction);
}

TEST(GapFriction, IsZeroWithoutABreadth) {
  CaseDefinition definition = narrow_tank();
  definition.tank.breadth.reset();
  EXPECT_EQ(gap_friction(definition), 0);
}

}  // namespace
}  // namespace slosh::gap_friction_test
