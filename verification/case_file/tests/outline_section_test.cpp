// Tanks that are no rectangles, and what is measured in them.
#include <gtest/gtest.h>

#include <numbers>

#include "verification/case/shape/tank_shape.hpp"
#include "verification/case_file/tests/refusals.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::outline_section_test {
namespace {

// 1 m at the bottom, 2 m at the top, 1 m high; the still surface at 0.5 m reaches from 0.25
// to 1.75.
const std::string trapezium = "outline_m = [[0.5, 0], [1.5, 0.0], [2, 1], [0, 1]]\n";

// The valid case in another tank, without theory, gate and natural modes.
std::string with_tank(const std::string& keys) {
  std::string text = edited({"length_m = 2\nheight_m = 1.0\n", keys});
  text.erase(text.find("[[gate]]"));
  const std::size_t theory = text.find("[[run]]");
  text.erase(theory, text.find("[[run]]", theory + 1) - theory);
  return with_keys(text,
                   "comparison.natural_modes = 0 & gauge(right).x_m = 1.7 & gauge(left).x_m = 0.3");
}

TEST(TankOutline, IsReadWithTheSizeOfTheRectangleAroundIt) {
  const CaseDefinition definition = read_text(with_tank(trapezium + "breadth_m = 0.1\n"));
  ASSERT_EQ(definition.tank.outline.size(), 4u);
  EXPECT_EQ(definition.tank.outline[0].x, 0.5);
  EXPECT_EQ(definition.tank.outline[2].z, 1);
  EXPECT_EQ(definition.tank.length, 2);
  EXPECT_EQ(definition.tank.height, 1);
  EXPECT_EQ(definition.tank.breadth, 0.1);
  EXPECT_FALSE(definition.tank.diameter);
  EXPECT_DOUBLE_EQ(liquid_area(definition), 0.625);
}

TEST(TankOutline, MayRunOverSeveralLines) {
  const std::string lines = "outline_m = [\n[0, 0],\n  [2, 0],\n[1.8, 1], [0.2, 1]]\n";
  EXPECT_EQ(read_text(with_tank(lines)).tank.outline.size(), 4u);
}

TEST(TankOutline, OfACylinderHasTheAreaOfTheCircle) {
  const CaseDefinition definition = read_text(with_tank("diameter_m = 2\n"));
  EXPECT_EQ(definition.tank.diameter, 2.0);
  ASSERT_EQ(definition.tank.outline.size(), 128u);
  EXPECT_NEAR(signed_area(definition.tank.outline), std::numbers::pi, 1e-13);
  EXPECT_NEAR(definition.tank.length, 1.9998, 1e-4);
  EXPECT_EQ(definition.tank.length, definition.tank.height);
}

TEST(TankOutline, IsRefusedBesideAnotherShape) {
  expect_refusals(with_tank(trapezium), R"(
tank.length_m = 2: expected no length_m beside outline_m, which tells the tank's whole shape
tank.diameter_m = 2: expected no diameter_m beside outline_m
liquid.fill_depth_m = 1.0: expected a number > 0 and below the tank's height (1), in m
gauge(right).x_m = 1.8: expected a number from 0.25 to 1.75, in m: the still surface at the fill
  depth (0.5) reaches from there to there
)");
  expect_refusals(with_tank("diameter_m = 2\n"), R"(
tank.height_m = 1.0: expected no height_m beside diameter_m
tank.diameter_m = 0: expected a number > 0, in m
tank.diameter_m is missing & tank.outline = 3: expected only these keys here: length_m, height_m,
  outline_m, diameter_m, breadth_m; nearest known key: outline_m
)");
}

TEST(TankOutline, IsRefusedWhereItIsNoTank) {
  expect_refusals(with_tank(trapezium), R"(
tank.outline_m = 3: expected an array of pairs, each a corner [x, z]
tank.outline_m = [[0, 0], [1, 0], [1, 1, 0]] -> tank.outline_m = [1, 1, 0]: expected a corner [x, z]
  of two finite numbers, in m
tank.outline_m = [[0, 0], [1, nan], [1, 1]] -> tank.outline_m = [1, nan]: expected a corner
tank.outline_m = [[0, 0], [1, 0], [inf, 1]] -> tank.outline_m = [inf, 1]: expected a corner
tank.outline_m = [[0, 0], [1, "a"], [1, 1]] -> tank.outline_m = [1, "a"]: expected a corner
tank.outline_m = [0, 0, 1, 1] -> tank.outline_m = 0: expected a corner
tank.outline_m = [[0, 0], [1, 1]] -> tank.outline_m = (an array): expected 3 to 1000 corners [x, z],
  in m, where these are 2
tank.outline_m = [[0.1, 0], [1, 0], [1, 1]] -> tank.outline_m = [0.1, 0]: expected corners whose
  smallest x is 0, in m, where this x is the smallest
tank.outline_m = [[0, 0], [1, -0.5], [1, 1]] -> tank.outline_m = [1, -0.5]: expected corners whose
  smallest z is 0
tank.outline_m = [[0, 0], [0, 1], [1, 1], [1, 0]] -> tank.outline_m = (an array): expected corners in
  counter-clockwise order, where these are clockwise
tank.outline_m = [[0, 0], [2, 0.9], [2, 0], [0, 1]] -> tank.outline_m = (an array): expected sides
  that meet at their common corners alone, where the sides that begin at the corners 1 and 3 meet
  elsewhere
tank.outline_m = [[0, 0], [2, 0], [2, 0], [0, 1]] -> tank.outline_m = (an array): expected sides that
  meet at their common
tank.outline_m = [[0, 0], [2, 0], [2, 1], [1, 0.7], [0, 1]] -> tank.outline_m = (an array): expected
  a tank that each horizontal line cuts in two places at most
)");
  std::string many = "tank.outline_m = [";
  for (int i = 0; i < 1001; ++i) many += "[" + std::to_string(i) + ", 0], ";
  expect_refusals(with_tank(trapezium),
                  many + "] -> tank.outline_m = (an array): expected 3 to 1000 corners");
  const std::string second = complaint_about(
      {"length_m = 2\nheight_m = 1.0\n", "outline_m = [[0, 0], [1, 0],\n[1, 1, 0]]\n"});
  EXPECT_TRUE(begins(second, "trial.toml:9: tank.outline_m = [1, 1, 0]"));
}

std::string with_sensor(const std::string& keys) {
  return with_tank(trapezium) + "[[pressure_gauge]]\nname = \"b\"\n" + keys;
}

TEST(PressureGaugeOfAnOutline, IsPutOnTheNearestSide) {
  const CaseDefinition definition =
      read_text(with_sensor("x_m = 1.7500004\nz_m = 0.5\nwidth_m = 0.4\n"));
  const PressureGaugeDefinition& gauge = definition.pressure_gauges.at(0);
  ASSERT_TRUE(gauge.at);
  EXPECT_NEAR(gauge.at->x, 1.75, 1e-6);
  EXPECT_EQ(nearest_on(definition.tank.outline, *gauge.at).side, 1u);
  EXPECT_NEAR(nearest_on(definition.tank.outline, *gauge.at).distance, 0, 1e-15);
  EXPECT_EQ(gauge.width, 0.4);
}

TEST(PressureGaugeOfAnOutline, IsRefusedWhereItMakesNoSense) {
  expect_refusals(with_sensor("x_m = 1.4\nz_m = 0\n"), R"(
pressure_gauge.width_m = 0.3: expected a number >= 0 and <= 0.2, in m: the whole sensor lies on the
  wall
pressure_gauge.z_m = 0.5 & pressure_gauge.x_m = 1.6: expected x_m and z_m of a place on the tank's
  outline to within 2e-06 m, where the nearest to (1.6, 0.5) is
pressure_gauge.z_m is missing: expected a number, in m
)");
  expect_refusals(with_sensor("position_m = 0.1\n"), R"(
pressure_gauge.wall = "left": expected no wall in a tank that is no rectangle, where x_m and z_m tell
  a sensor's place
)");
  expect_refusals(valid_text + "[[pressure_gauge]]\nname = \"b\"\nz_m = 0\n", R"(
pressure_gauge.x_m = 1: expected no x_m in a rectangular tank, where wall and position_m tell a
  sensor's place
)");
}

TEST(ProbeOfAnOutline, IsInsideIt) {
  const std::string text = with_tank(trapezium) + "[[probe]]\nname = \"p\"\nx_m = 0.5\nz_m = 0.1\n";
  EXPECT_EQ(read_text(text).probes.at(0).x, 0.5);
  expect_refusals(text, R"(
probe.x_m = 0.4: expected a place inside the tank's outline, which reaches from x = 0.45 to 1.55 at
  z_m = 0.1, in m
)");
}

}  // namespace
}  // namespace slosh::outline_section_test
