#include "verification/case/shape/tank_shape.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "verification/case/changed_input.hpp"
#include "verification/case/gap_friction.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/shape/outline.hpp"
#include "verification/case/shape/sensor_place.hpp"

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

TEST(TankShape, IsThatOfARectangleOfADamsColumnOrOfAnOutline) {
  CaseDefinition definition = filled({}, 0.35);
  const Outline corners = corners_of(definition.tank);
  ASSERT_EQ(corners.size(), 4u);
  EXPECT_EQ(still_surface(definition).length(), 2);
  EXPECT_DOUBLE_EQ(liquid_area(definition), 0.7);
  definition.liquid.column_width = 0.2;
  EXPECT_DOUBLE_EQ(liquid_area(definition), 0.07);
  const CaseDefinition sloped = filled(trapezium, 0.5);
  EXPECT_DOUBLE_EQ(still_surface(sloped).left, 0.25);
  EXPECT_DOUBLE_EQ(still_surface(sloped).right, 1.75);
  EXPECT_DOUBLE_EQ(liquid_area(sloped), 0.625);
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

using std::numbers::pi;

// A tank with sloped walls: 1 m at the bottom, 2 m at the top, 1 m high.
const Outline bow_tie{{0, 0}, {1, 1}, {1, 0}, {0, 1}};

TEST(Outline, HasItsAreaAndThatBelowALevel) {
  EXPECT_DOUBLE_EQ(signed_area(trapezium), 1.5);
  EXPECT_DOUBLE_EQ(signed_area({trapezium.rbegin(), trapezium.rend()}), -1.5);
  EXPECT_DOUBLE_EQ(area_below(trapezium, 0.5), 0.5 * (1 + 1.5) / 2);
  EXPECT_DOUBLE_EQ(area_below(trapezium, 1), 1.5);
  EXPECT_DOUBLE_EQ(area_below(trapezium, 2), 1.5);
  EXPECT_DOUBLE_EQ(area_below(trapezium, 0), 0);
}

TEST(Outline, MeetsALevelFromWallToWall) {
  const Extent middle = extent_at(trapezium, 0.5);
  EXPECT_DOUBLE_EQ(middle.left, 0.25);
  EXPECT_DOUBLE_EQ(middle.right, 1.75);
  EXPECT_DOUBLE_EQ(middle.length(), 1.5);
  EXPECT_DOUBLE_EQ(extent_at(trapezium, 0).length(), 1);
  EXPECT_DOUBLE_EQ(extent_at(trapezium, 1).length(), 2);
}

TEST(Outline, TellsTheSidesThatMeetElsewhereThanAtTheirCorner) {
  EXPECT_FALSE(crossing_sides(trapezium));
  EXPECT_EQ(crossing_sides(bow_tie), std::pair(std::size_t{0}, std::size_t{2}));
  EXPECT_TRUE(crossing_sides({{0, 0}, {1, 0}, {1, 0}, {1, 1}})) << "a corner twice";
  EXPECT_TRUE(crossing_sides({{0, 0}, {1, 0}, {0.5, 0}, {1, 1}})) << "a side runs back";
  EXPECT_TRUE(crossing_sides({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}})) << "a corner on a side";
  EXPECT_FALSE(crossing_sides({{0, 0}, {1, 0}, {2, 0}, {1, 1}})) << "a corner in a straight side";
}

TEST(Outline, IsCutInOnePieceUnlessItHasTwoHumpsOrTwoPits) {
  EXPECT_TRUE(is_in_one_piece_at_each_level(trapezium));
  EXPECT_TRUE(is_in_one_piece_at_each_level({{0, 0}, {1, 0}, {1, 0.5}, {2, 0.5}, {2, 1}, {0, 1}}))
      << "a step";
  EXPECT_FALSE(is_in_one_piece_at_each_level({{0, 0}, {2, 0}, {2, 1}, {1, 0.5}, {0, 1}}));
  EXPECT_FALSE(is_in_one_piece_at_each_level({{0, 0}, {1, 0.5}, {2, 0}, {2, 1}, {0, 1}}));
}

TEST(Outline, ContainsItsInsideAndItsSides) {
  EXPECT_TRUE(contains(trapezium, {1, 0.5}));
  EXPECT_TRUE(contains(trapezium, {1, 0}));
  EXPECT_TRUE(contains(trapezium, {0.25, 0.5}));
  EXPECT_TRUE(contains(trapezium, {2, 1}));
  EXPECT_FALSE(contains(trapezium, {0.2, 0.5}));
  EXPECT_FALSE(contains(trapezium, {1, -0.001}));
  EXPECT_FALSE(contains(trapezium, {1.8, 0.5}));
}

TEST(Outline, HasTheNearestPlaceOnASide) {
  const PlaceOnOutline on = nearest_on(trapezium, {1.2, -0.1});
  EXPECT_EQ(on.side, 0u);
  EXPECT_DOUBLE_EQ(on.along, 0.7);
  EXPECT_DOUBLE_EQ(on.distance, 0.1);
  EXPECT_DOUBLE_EQ(on.place.x, 1.2);
  EXPECT_DOUBLE_EQ(on.place.z, 0);
  EXPECT_DOUBLE_EQ(side_length(trapezium, 1), std::sqrt(1.25));
}

TEST(Outline, IsFollowedRoundItsCorners) {
  const Outline square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const Corner up = moved_along(square, {0.9, 0}, 0.3);
  EXPECT_NEAR(up.x, 1, 1e-15);
  EXPECT_NEAR(up.z, 0.2, 1e-15);
  const Corner back = moved_along(square, {0.1, 0}, -0.3);
  EXPECT_NEAR(back.x, 0, 1e-15);
  EXPECT_NEAR(back.z, 0.2, 1e-15);
}

TEST(Outline, IsSymmetricWhereItsImageIsTheSame) {
  EXPECT_TRUE(is_symmetric(trapezium));
  EXPECT_TRUE(is_symmetric(cylinder_outline(0.3)));
  EXPECT_FALSE(is_symmetric({{0, 0}, {1, 0}, {2, 1}, {0, 1}}));
}

TEST(CylinderOutline, HasTheCirclesAreaAndAFlatBottomFromTheOrigin) {
  for (const double diameter : {0.1, 1.0, 37.3}) {
    const Outline outline = cylinder_outline(diameter);
    ASSERT_EQ(outline.size(), 128u);
    const double area = pi * diameter * diameter / 4;
    EXPECT_NEAR(signed_area(outline), area, 1e-13 * area);
    EXPECT_EQ(outline.front().z, 0);
    EXPECT_EQ(outline.back().z, 0);
    double least_x = 1, least_z = 1, length = 0, height = 0;
    for (const Corner& corner : outline) {
      least_x = std::min(least_x, corner.x);
      least_z = std::min(least_z, corner.z);
      length = std::max(length, corner.x);
      height = std::max(height, corner.z);
    }
    EXPECT_EQ(least_x, 0);
    EXPECT_EQ(least_z, 0);
    EXPECT_EQ(length, height);
    EXPECT_NEAR(length, 0.9999 * diameter, 1e-5 * diameter);
    EXPECT_FALSE(crossing_sides(outline));
    EXPECT_TRUE(is_in_one_piece_at_each_level(outline));
    EXPECT_NEAR(area_below(outline, height / 2), area / 2, 1e-13 * area);
  }
}

// The segment of a circle below the depth h: r^2 acos(1 - h / r) - (r - h) sqrt(2 r h - h^2).
TEST(CylinderOutline, HoldsTheLiquidOfTheCircle) {
  const Outline outline = cylinder_outline(1);
  for (const double depth : {0.2, 0.35, 0.7}) {
    const double r = 0.5, circle = r * r * std::acos(1 - depth / r) -
                                   (r - depth) * std::sqrt(2 * r * depth - depth * depth);
    EXPECT_NEAR(area_below(outline, depth), circle, 5e-4 * circle) << depth;
  }
}

CaseDefinition rectangle() {
  CaseDefinition definition{};
  definition.tank = {.length = 2, .height = 1};
  definition.liquid = {.fill_depth = 0.5, .density = 1000, .kinematic_viscosity = 1e-6};
  return definition;
}

void expect_place(Corner place, double x, double z) {
  EXPECT_NEAR(place.x, x, 1e-15);
  EXPECT_NEAR(place.z, z, 1e-15);
}

TEST(SensorPlace, IsOnItsWall) {
  const TankDefinition tank = rectangle().tank;
  expect_place(sensor_middle(tank, {"a", Wall::left, 0.3}), 0, 0.3);
  expect_place(sensor_middle(tank, {"a", Wall::right, 0.3}), 2, 0.3);
  expect_place(sensor_middle(tank, {"a", Wall::bottom, 0.3}), 0.3, 0);
  expect_place(sensor_middle(tank, {"a", Wall::roof, 0.3}), 0.3, 1);
  const auto [first, last] = sensor_ends(tank, {"a", Wall::left, 0.3, 0.1});
  expect_place(first, 0, 0.25);
  expect_place(last, 0, 0.35);
}

TEST(SensorPlace, ReachesAlongItsSideOfAnOutline) {
  const TankDefinition tank{.length = 3, .height = 4, .outline = {{0, 0}, {3, 4}, {0, 4}}};
  const PressureGaugeDefinition gauge{
      .name = "a", .wall = Wall::bottom, .position = 0, .width = 1, .at = Corner{1.5, 2}};
  const auto [first, last] = sensor_ends(tank, gauge);
  expect_place(sensor_middle(tank, gauge), 1.5, 2);
  expect_place(first, 1.2, 1.6);
  expect_place(last, 1.8, 2.4);
}

TEST(SensorPlace, IsUnderStillWaterIfAllOfItIs) {
  const CaseDefinition definition = rectangle();
  const auto is_under = [&](Wall wall, double position, double width) {
    return is_under_still_water(definition, {"a", wall, position, width});
  };
  EXPECT_TRUE(is_under(Wall::left, 0.4, 0.1));
  EXPECT_FALSE(is_under(Wall::left, 0.45, 0.1));
  EXPECT_TRUE(is_under(Wall::bottom, 1.9, 0.2));
  EXPECT_FALSE(is_under(Wall::roof, 0.1, 0));
  CaseDefinition sloped = definition;
  sloped.tank.outline = {{0.5, 0}, {1.5, 0}, {2, 1}, {0, 1}};
  PressureGaugeDefinition gauge{
      .name = "a", .wall = Wall::bottom, .position = 0, .at = Corner{1.7, 0.4}};
  EXPECT_TRUE(is_under_still_water(sloped, gauge));
  gauge.width = 0.3;  // reaches 0.13 m higher
  EXPECT_FALSE(is_under_still_water(sloped, gauge));
}

}  // namespace
}  // namespace slosh::tank_shape_test
