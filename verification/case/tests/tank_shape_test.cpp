#include "verification/case/shape/tank_shape.hpp"

#include <gtest/gtest.h>

#include "verification/case/changed_input.hpp"
#include "verification/case/gap_friction.hpp"
#include "verification/case/quantities.hpp"

namespace slosh::tank_shape_test {
namespace {

CaseDefinition filled(const Outline& outline, double depth) {
  CaseDefinition definition{};
  definition.gravity = 9.81;
  definition.tank = {.length = 2, .height = 1, .outline = outline};
  definition.liquid = {.fill_depth = depth, .density = 1000, .kinematic_viscosity = 1e-6};
  return definition;
}

const Outline trapezium{{0.5, 0}, {1.5, 0}, {2, 1}, {0, 1}};
const Outline skew{{0, 0}, {1, 0}, {2, 1}, {0, 1}};

TEST(TankShape, OfARectangleIsThatOfItsFourCorners) {
  const CaseDefinition definition = filled({}, 0.35);
  const Outline corners = corners_of(definition.tank);
  ASSERT_EQ(corners.size(), 4u);
  EXPECT_EQ(still_surface(definition).length(), 2);
  EXPECT_DOUBLE_EQ(liquid_area(definition), 0.7);
}

TEST(TankShape, OfADamHoldsItsColumnAlone) {
  CaseDefinition definition = filled({}, 0.5);
  definition.liquid.column_width = 0.25;
  EXPECT_DOUBLE_EQ(liquid_area(definition), 0.125);
}

TEST(TankShape, OfAnOutlineIsThatOfItsSection) {
  const CaseDefinition definition = filled(trapezium, 0.5);
  EXPECT_EQ(corners_of(definition.tank).size(), 4u);
  EXPECT_DOUBLE_EQ(still_surface(definition).left, 0.25);
  EXPECT_DOUBLE_EQ(still_surface(definition).right, 1.75);
  EXPECT_DOUBLE_EQ(liquid_area(definition), 0.625);
}

TEST(NaturalModes, OfAnUnsymmetricTankAreAllExcited) {
  EXPECT_EQ(natural_modes(filled({}, 0.5), 3), (std::vector<int>{1, 3, 5}));
  EXPECT_EQ(natural_modes(filled(trapezium, 0.5), 3), (std::vector<int>{1, 3, 5}));
  EXPECT_EQ(natural_modes(filled(skew, 0.5), 3), (std::vector<int>{1, 2, 3}));
}

TEST(GapFriction, OfAnOutlineNeedsTheForcingsFrequency) {
  CaseDefinition definition = filled(trapezium, 0.5);
  definition.tank.breadth = 0.1;
  EXPECT_THROW(gap_friction(definition), std::invalid_argument);
  definition.motion.surge = SineMotion{0.01, 3.8};
  EXPECT_DOUBLE_EQ(gap_friction(definition), layers_between_walls(0.1, 1e-6, 3.8).friction);
}

TEST(ChangedSensorPosition, FollowsTheOutline) {
  CaseDefinition definition = filled(trapezium, 0.5);
  definition.pressure_gauges = {
      {.name = "b", .wall = Wall::bottom, .position = 0, .at = Corner{1.4, 0}}};
  const CaseDefinition changed = with_input(definition, Input::sensor_position, 0.05);
  EXPECT_NEAR(changed.pressure_gauges[0].at->x, 1.45, 1e-15);
  EXPECT_NEAR(changed.pressure_gauges[0].at->z, 0, 1e-15);
  const Corner round = *with_input(definition, Input::sensor_position, 0.2).pressure_gauges[0].at;
  EXPECT_NEAR(nearest_on(trapezium, round).distance, 0, 1e-15);
  EXPECT_EQ(nearest_on(trapezium, round).side, 1u);
}

}  // namespace
}  // namespace slosh::tank_shape_test
