// What a tank that is no rectangle excludes.
#include <gtest/gtest.h>

#include "verification/case/solver_kinds.hpp"
#include "verification/case_file/tests/refusals.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::outline_limits_test {
namespace {

const std::string top = R"(schema_version = 1
name = "trial"
title = "A trial"
source = "none"
)";
const std::string tables = R"([tank]
diameter_m = 1.0
[liquid]
fill_depth_m = 0.4
[motion.surge]
type = "sine"
amplitude_m = 0.02
period_s = 1.1
[time]
start = "tank"
duration_s = 5.0
sample_interval_s = 0.01
[[gauge]]
name = "middle"
x_m = 0.5
[comparison]
window_begin_s = 1.0
natural_modes = 0
)";
const std::string runs = R"([[run]]
name = "sph"
solver = "sph"
scheme = "recommended"
particle_spacing_m = 0.02
[[run]]
name = "mesh"
solver = "interfoam"
cells_x = 50
cells_z = 50
)";

const std::string trial = top + tables + runs;

std::string complaint_of(const std::string& text) {
  const Workspace workspace;
  return complaint(workspace.write("trial.toml", text));
}

TEST(Outline, ExcludesWhatStandsAtTheWallsOfARectangle) {
  const std::string all = complaint_of(
      with_keys(trial, "wall_forces = [\"left\"] & liquid.column_width_m = 0.2") +
      "[[obstacle]]\nname = \"baffle\"\nleft_m = 0.4\nright_m = 0.5\nbottom_m = 0\ntop_m = 0.1\n"
      "[initial_wave]\nmode = 1\namplitude_m = 0.01\n");
  for (const char* wanted :
       {"trial.toml:5: wall_forces = (an array): expected no wall_forces beside tank.diameter_m: "
        "its sides have no names",
        "obstacle = (an array of tables): expected no [[obstacle]] beside tank.diameter_m: an "
        "obstacle stands between the walls of a rectangle",
        "initial_wave = (a table): expected no [initial_wave] beside tank.diameter_m: its cosine "
        "is a mode of a rectangle",
        "liquid.column_width_m = 0.2: expected no column_width_m beside tank.diameter_m: a dam "
        "stands at the left wall of a rectangle"})
    EXPECT_TRUE(holds(all, wanted));
}

TEST(Outline, IsTakenBySphAndInterFoamWithNaturalModesAndFrictionBetweenWalls) {
  expect_refusals(trial, R"(
comparison.natural_modes = 0: accepted
comparison.natural_modes = 2: accepted
tank.breadth_m = 0.1: accepted
)");
  std::string two = trial;
  const std::string sine = "type = \"sine\"\namplitude_m = 0.02\nperiod_s = 1.1\n";
  two.replace(two.find(sine), sine.size(),
              "type = \"sines\"\nsines = [{ amplitude_m = 0.02, period_s = 1.3 }, { amplitude_m = "
              "0.005, period_s = 0.7 }]\n");
  expect_refusals(two, R"(
tank.breadth_m = 0.1: expected no breadth_m beside tank.diameter_m unless the motion has a single
  frequency
)");
}

TEST(Outline, HasALinearTheoryOfUpTo150ModesWithoutGas) {
  expect_refusals(trial +
                      "[[run]]\nname = \"theory\"\nsolver = \"linear\"\n"
                      "valid_elevation_over_depth = 0.1\n",
                  R"(
run.modes = 40: accepted
run.modes = 1000: expected an integer from 1 to 150 beside tank.diameter_m
run.modes = 40 & run.two_layer = true: expected ... its theory has no gas
)");
}

TEST(Outline, ExcludesSolversThatKnowRectanglesAlone) {
  expect_refusals(trial + "[[run]]\nname = \"a\"\n", R"(
run.solver = "potential": expected one of sph, interfoam, interisofoam, compressible_interfoam,
  linear, record, external, stored, which know more than rectangles, beside tank.diameter_m
run.solver = "viscous_wave": expected one of sph, interfoam, interisofoam, compressible_interfoam,
run.solver = "pysph": expected one of sph, interfoam, interisofoam, compressible_interfoam,
run.solver = "intrefoam": expected ... nearest: interfoam
)");
  EXPECT_EQ(solvers_that_take_outlines(),
            (std::vector<std::string>{"sph", "interfoam", "interisofoam", "compressible_interfoam",
                                      "linear", "record", "external", "stored"}));
}

}  // namespace
}  // namespace slosh::outline_limits_test
