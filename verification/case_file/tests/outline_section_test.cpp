// Tanks that are no rectangles, and what is measured in them.
#include <gtest/gtest.h>

#include <numbers>

#include "verification/case/shape/tank_shape.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::outline_section_test {
namespace {

// 1 m at the bottom, 2 m at the top, 1 m high; the still surface at 0.5 m reaches from 0.25
// to 1.75.
const std::string trapezium = "outline_m = [[0.5, 0], [1.5, 0.0], [2, 1], [0, 1]]\n";

// The valid case in another tank, on lines 7 and 8, without theory, gate and natural modes.
std::string with_tank(const std::string& keys) {
  std::string text = edited({"length_m = 2\nheight_m = 1.0\n", keys});
  text.erase(text.find("[[gate]]"));
  const auto replace = [&](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  replace("natural_modes = 2", "natural_modes = 0");
  replace(
      "[[run]]\nname = \"theory\"\nsolver = \"linear\"\nmodes = 500\n"
      "valid_elevation_over_depth = 0.1\n",
      "");
  replace("x_m = 1.95", "x_m = 1.7");
  replace("x_m = 0.05", "x_m = 0.3");
  return text;
}

std::string complaint_of(const std::string& text) {
  const Workspace workspace;
  return complaint(workspace.write("trial.toml", text));
}

void expect_refusal(const std::string& text, const std::string& wanted) {
  const std::string message = complaint_of(text);
  EXPECT_TRUE(message.starts_with(wanted)) << "got:    " << message << "\nwanted: " << wanted;
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
  expect_refusal(with_tank("length_m = 2\n" + trapezium),
                 "trial.toml:8: tank.length_m = 2: expected no length_m beside outline_m, which "
                 "tells the tank's whole shape");
  expect_refusal(with_tank("height_m = 1.0\ndiameter_m = 2\n"),
                 "trial.toml:8: tank.height_m = 1.0: expected no height_m beside diameter_m");
  expect_refusal(with_tank("diameter_m = 2\n" + trapezium),
                 "trial.toml:8: tank.diameter_m = 2: expected no diameter_m beside outline_m");
  expect_refusal(with_tank("diameter_m = 0\n"),
                 "trial.toml:8: tank.diameter_m = 0: expected a number > 0, in m");
  expect_refusal(with_tank("outline = 3\n"),
                 "trial.toml:8: tank.outline = 3: expected only these keys here: length_m, "
                 "height_m, outline_m, diameter_m, breadth_m; nearest known key: outline_m");
}

TEST(TankOutline, IsRefusedWhereItIsNoTank) {
  const std::string corner = "expected a corner [x, z] of two finite numbers, in m";
  const std::vector<std::pair<std::string, std::string>> outlines{
      {"3", "trial.toml:8: tank.outline_m = 3: expected an array of pairs, each a corner [x, z]"},
      {"[[0, 0], [1, 0],\n[1, 1, 0]]", "trial.toml:9: tank.outline_m = [1, 1, 0]: " + corner},
      {"[[0, 0], [1, nan], [1, 1]]", "trial.toml:8: tank.outline_m = [1, nan]: " + corner},
      {"[[0, 0], [1, 0], [inf, 1]]", "trial.toml:8: tank.outline_m = [inf, 1]: " + corner},
      {"[[0, 0], [1, \"a\"], [1, 1]]", "trial.toml:8: tank.outline_m = [1, \"a\"]: " + corner},
      {"[0, 0, 1, 1]", "trial.toml:8: tank.outline_m = 0: " + corner},
      {"[[0, 0], [1, 1]]",
       "trial.toml:8: tank.outline_m = (an array): expected 3 to 1000 corners [x, z], in m, where "
       "these are 2"},
      {"[[0.1, 0], [1, 0], [1, 1]]",
       "trial.toml:8: tank.outline_m = [0.1, 0]: expected corners whose smallest x is 0, in m, "
       "where this x is the smallest"},
      {"[[0, 0],\n[1, -0.5],\n[1, 1]]",
       "trial.toml:9: tank.outline_m = [1, -0.5]: expected corners whose smallest z is 0"},
      {"[[0, 0], [0, 1], [1, 1], [1, 0]]",
       "trial.toml:8: tank.outline_m = (an array): expected corners in counter-clockwise order, "
       "where these are clockwise"},
      {"[[0, 0], [2, 0.9], [2, 0], [0, 1]]",
       "trial.toml:8: tank.outline_m = (an array): expected sides that meet at their common "
       "corners alone, where the sides that begin at the corners 1 and 3 meet elsewhere"},
      {"[[0, 0], [2, 0], [2, 0], [0, 1]]",
       "trial.toml:8: tank.outline_m = (an array): expected sides that meet at their common"},
      {"[[0, 0], [2, 0], [2, 1], [1, 0.7], [0, 1]]",
       "trial.toml:8: tank.outline_m = (an array): expected a tank that each horizontal line cuts "
       "in two places at most"}};
  for (const auto& [outline, wanted] : outlines)
    expect_refusal(with_tank("outline_m = " + outline + "\n"), wanted);
  std::string many = "outline_m = [";
  for (int i = 0; i < 1001; ++i) many += "[" + std::to_string(i) + ", 0], ";
  expect_refusal(with_tank(many + "]\n"),
                 "trial.toml:8: tank.outline_m = (an array): expected 3 to 1000 corners");
}

TEST(TankOutline, HoldsItsLiquidBelowItsTop) {
  std::string text = with_tank(trapezium);
  text.replace(text.find("fill_depth_m = 0.5"), 18, "fill_depth_m = 1.0");
  expect_refusal(text,
                 "trial.toml:10: liquid.fill_depth_m = 1.0: expected a number > 0 and below the "
                 "tank's height (1), in m");
}

TEST(SurfaceGaugeOfAnOutline, StandsInTheStillSurface) {
  std::string text = with_tank(trapezium);
  text.replace(text.find("x_m = 1.7"), 9, "x_m = 1.8");
  expect_refusal(text,
                 "trial.toml:26: gauge.x_m = 1.8: expected a number from 0.25 to 1.75, in m: the "
                 "still surface at the fill depth (0.5) reaches from there to there");
}

std::string with_sensor(const std::string& keys) {
  std::string text = with_tank(trapezium);
  return text.insert(text.find("[comparison]"), "[[pressure_gauge]]\nname = \"b\"\n" + keys);
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
  expect_refusal(with_sensor("x_m = 1.6\nz_m = 0.5\n"),
                 "trial.toml:32: pressure_gauge.x_m = 1.6: expected x_m and z_m of a place on the "
                 "tank's outline to within 2e-06 m, where the nearest to (1.6, 0.5) is");
  expect_refusal(with_sensor("wall = \"left\"\nposition_m = 0.1\n"),
                 "trial.toml:32: pressure_gauge.wall = \"left\": expected no wall in a tank that "
                 "is no rectangle, where x_m and z_m tell a sensor's place");
  expect_refusal(with_sensor("x_m = 1.0\n"),
                 "trial.toml:30: pressure_gauge.z_m is missing: expected a number, in m");
  expect_refusal(with_sensor("x_m = 1.4\nz_m = 0\nwidth_m = 0.3\n"),
                 "trial.toml:34: pressure_gauge.width_m = 0.3: expected a number >= 0 and <= 0.2, "
                 "in m: the whole sensor lies on the wall");
}

TEST(PressureGaugeOfARectangle, TakesNoPlaceOfAnOutline) {
  expect_refusal(edited({"[comparison]",
                         "[[pressure_gauge]]\nname = \"b\"\nx_m = 1\nz_m = "
                         "0\n[comparison]"}),
                 "trial.toml:33: pressure_gauge.x_m = 1: expected no x_m in a rectangular tank, "
                 "where wall and position_m tell a sensor's place");
}

TEST(ProbeOfAnOutline, IsInsideIt) {
  const auto with_probe = [](const std::string& x) {
    std::string text = with_tank(trapezium);
    return text.insert(text.find("[comparison]"),
                       "[[probe]]\nname = \"p\"\nx_m = " + x + "\nz_m = 0.1\n");
  };
  EXPECT_EQ(read_text(with_probe("0.5")).probes.at(0).x, 0.5);
  expect_refusal(
      with_probe("0.4"),
      "trial.toml:32: probe.x_m = 0.4: expected a place inside the tank's outline, which "
      "reaches from x = 0.45 to 1.55 at z_m = 0.1, in m");
}

}  // namespace
}  // namespace slosh::outline_section_test
