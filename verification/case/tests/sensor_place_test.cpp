#include "verification/case/shape/sensor_place.hpp"

#include <gtest/gtest.h>

namespace slosh::sensor_place_test {
namespace {

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
}  // namespace slosh::sensor_place_test
