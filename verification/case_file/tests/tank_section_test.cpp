// Tanks that are no rectangles, and what is measured in them.
#include <gtest/gtest.h>

#include "verification/case/quantities.hpp"
#include "verification/case/shape/tank_shape.hpp"
#include "verification/case_file/tests/refusals.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::tank_section_test {
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
  const CaseDefinition cylinder = read_text(with_tank("diameter_m = 2\n"));
  EXPECT_EQ(cylinder.tank.diameter, 2.0);
  EXPECT_EQ(cylinder.tank.outline.size(), 128u);
  EXPECT_EQ(cylinder.tank.length, cylinder.tank.height);
}

TEST(TankOutline, IsRefusedBesideAnotherShape) {
  expect_refusals(with_tank(trapezium), R"(
tank.length_m = 2: expected no length_m beside outline_m, which tells the tank's whole shape
tank.diameter_m = 2: expected no diameter_m beside outline_m
gauge(right).x_m = 1.8: expected a number from 0.25 to 1.75, in m: the still surface at the fill
  depth (0.5) reaches from there to there
)");
  expect_refusals(with_tank("diameter_m = 2\n"), R"(
tank.height_m = 1.0: expected no height_m beside diameter_m
)");
}

TEST(TankOutline, IsRefusedWhereItIsNoTank) {
  expect_refusals(with_tank(trapezium), R"(
tank.outline_m = 3: expected an array of pairs, each a corner [x, z]
tank.outline_m = [[0, 0], [1, 0], [1, 1, 0]] -> tank.outline_m = [1, 1, 0]: expected a corner [x, z]
  of two finite numbers, in m
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
  const std::string lines = "outline_m = [\n[0, 0],\n  [2, 0],\n[1.8, 1], [0.2, 1]]\n";
  EXPECT_EQ(read_text(with_tank(lines)).tank.outline.size(), 4u);
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
)");
  expect_refusals(with_sensor("position_m = 0.1\n"), R"(
pressure_gauge.wall = "left": expected no wall in a tank that is no rectangle, where x_m and z_m tell
  a sensor's place
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

// What a tank that is no rectangle excludes.

const std::string cylinder = with_tank("diameter_m = 2\n");

TEST(Outline, ExcludesWhatStandsAtTheWallsOfARectangle) {
  const Workspace workspace;
  const std::string all = complaint(workspace.write(
      "trial.toml", with_keys(cylinder, "liquid.column_width_m = 0.2") +
                        "[[obstacle]]\nname = \"baffle\"\nleft_m = 0.4\nright_m = 0.5\nbottom_m = "
                        "0\ntop_m = 0.1\n"
                        "[initial_wave]\nmode = 1\namplitude_m = 0.01\n"));
  for (const char* wanted :
       {"obstacle = (an array of tables): expected no [[obstacle]] beside tank.diameter_m: an "
        "obstacle stands between the walls of a rectangle",
        "initial_wave = (a table): expected no [initial_wave] beside tank.diameter_m: its cosine "
        "is a mode of a rectangle",
        "liquid.column_width_m = 0.2: expected no column_width_m beside tank.diameter_m: a dam "
        "stands at the left wall of a rectangle"})
    EXPECT_TRUE(holds(all, wanted));
}

TEST(Outline, IsTakenBySphAndInterFoamWithNaturalModesAndFrictionBetweenWalls) {
  expect_refusals(cylinder, R"(
comparison.natural_modes = 0: accepted
comparison.natural_modes = 2: accepted
tank.breadth_m = 0.1: accepted
)");
  std::string two = cylinder;
  two.replace(two.find(sine_surge), sine_surge.size(),
              "[motion.surge]\ntype = \"sines\"\nsines = [{ amplitude_m = 0.02, period_s = 1.3 }, "
              "{ amplitude_m = 0.005, period_s = 0.7 }]\n");
  expect_refusals(two, R"(
tank.breadth_m = 0.1: expected no breadth_m beside tank.diameter_m unless the motion has a single
  frequency
)");
}

TEST(Outline, HasALinearTheoryOfUpTo150ModesWithoutGas) {
  expect_refusals(cylinder +
                      "[[run]]\nname = \"theory\"\nsolver = \"linear\"\n"
                      "valid_elevation_over_depth = 0.1\n",
                  R"(
run.modes = 40: accepted
run.modes = 1000: expected an integer from 1 to 150 beside tank.diameter_m
run.modes = 40 & run.two_layer = true: expected ... its theory has no gas
)");
}

TEST(Outline, ExcludesSolversThatKnowRectanglesAlone) {
  expect_refusals(cylinder + "[[run]]\nname = \"a\"\n", R"(
run.solver = "potential": expected one of sph, interfoam, interisofoam, compressible_interfoam,
  linear, record, external, stored, which know more than rectangles, beside tank.diameter_m
run.solver = "viscous_wave": expected one of sph, interfoam, interisofoam, compressible_interfoam,
run.solver = "pysph": expected one of sph, interfoam, interisofoam, compressible_interfoam,
run.solver = "intrefoam": expected ... nearest: interfoam
)");
}

// [initial_wave] of a case file: what it may say, and every mistake.

const std::string third_mode = "[initial_wave]\nmode = 3\namplitude_m = -0.02\n";

std::string with_wave(const std::string& section, std::string text = valid_text) {
  return text.insert(text.find("[time]"), section);
}

// In a still tank, where linear theory has no modes to sum.
std::string still_with_wave(const std::string& section) {
  const std::string text = with_wave(section, edited({sine_surge, "[motion]\nstill = true\n"}));
  return with_keys(text.substr(0, text.find("[[gate]]")),
                   "run(theory).modes is missing & comparison.natural_modes = 1");
}

TEST(InitialWaveSection, ReadsTheModeAndTheHeightAtTheLeftWall) {
  const CaseDefinition definition = read_text(still_with_wave(third_mode));
  ASSERT_TRUE(definition.initial_wave);
  EXPECT_EQ(definition.initial_wave->mode, 3);
  EXPECT_EQ(definition.initial_wave->amplitude, -0.02);
  EXPECT_FALSE(read_text(valid_text).initial_wave);
  EXPECT_EQ(natural_modes(definition, 1), std::vector<int>{3}) << "the one of a tank that stands";
  EXPECT_EQ(natural_modes(definition, 0), std::vector<int>{});
}

TEST(InitialWaveSection, JoinsTheModesThatTheTanksMotionExcites) {
  const std::string even = "[initial_wave]\nmode = 2\namplitude_m = 0.02\n";
  EXPECT_EQ(natural_modes(read_text(valid_text), 3), (std::vector{1, 3, 5}));
  EXPECT_EQ(natural_modes(read_text(with_wave(third_mode)), 3), (std::vector{1, 3, 5}));
  EXPECT_EQ(natural_modes(read_text(with_wave(even)), 3), (std::vector{1, 2, 3}));
}

TEST(InitialWaveSection, RefusesAWaveThatTheTankCannotHold) {
  expect_refusals(with_wave(third_mode), R"(
initial_wave.amplitude_m = 0.49: accepted
initial_wave.amplitude_m = 0.5: expected a number other than 0 of a magnitude below 0.5, in m:
  shallower than the liquid (0.5) and below the roof (0.5 above it)
initial_wave.amplitude_m = -0.5: expected a number other than 0 of a magnitude below 0.5
initial_wave.amplitude_m = 0: expected
initial_wave.mode = -1: expected an integer >= 1
liquid.column_width_m = 1 -> initial_wave = a wave on a dam about to break: expected liquid without
  column_width_m, which stands from wall to wall
)");
  const std::string obstacle =
      "[[obstacle]]\nname = \"baffle\"\nleft_m = 1.0\nright_m = 1.2\nbottom_m = 0.0\ntop_m = 0.2\n";
  expect_refusals(with_wave(obstacle + third_mode), R"(
-> initial_wave = a wave over an [[obstacle]]: expected a tank without one, whose modes are cosines
  from wall to wall
)");
  expect_refusals(still_with_wave(third_mode), R"(
comparison.natural_modes = 2: expected 0 or 1: a still tank has only the mode of its initial wave
run(theory).modes = 500: expected no such key for a still tank: its initial wave is a single mode
)");
}

TEST(InitialWaveSection, MayBeComparedWithAViscousWave) {
  const std::string text =
      with_keys(still_with_wave(third_mode), "run(theory).solver = \"viscous_wave\"");
  const CaseDefinition definition = read_text(text);
  EXPECT_EQ(std::get<ViscousWaveRun>(definition.runs.at(0).solver).valid_elevation_over_depth, 0.1);
  expect_refusals(text, "run(theory).two_layer = true: expected");
}

}  // namespace
}  // namespace slosh::tank_section_test
