// What a tank that is no rectangle excludes.
#include <gtest/gtest.h>

#include "verification/case/solver_kinds.hpp"
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

std::string complaint_of(const std::string& text) {
  const Workspace workspace;
  return complaint(workspace.write("trial.toml", text));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST(Outline, IsTakenBySphAndInterFoam) { EXPECT_EQ(complaint_of(top + tables + runs), ""); }

TEST(Outline, ExcludesWhatStandsAtTheWallsOfARectangle) {
  const std::string all =
      complaint_of(top + "wall_forces = [\"left\"]\n" +
                   replaced(tables, "fill_depth_m = 0.4\n",
                            "fill_depth_m = 0.4\ncolumn_width_m = "
                            "0.2\n") +
                   "[[obstacle]]\nname = \"baffle\"\nleft_m = 0.4\nright_m = 0.5\nbottom_m = 0\n"
                   "top_m = 0.1\n[initial_wave]\nmode = 1\namplitude_m = 0.01\n" +
                   runs);
  for (const char* wanted :
       {"trial.toml:5: wall_forces = (an array): expected no wall_forces beside tank.diameter_m: "
        "its sides have no names",
        "obstacle = (an array of tables): expected no [[obstacle]] beside tank.diameter_m: an "
        "obstacle stands between the walls of a rectangle",
        "initial_wave = (a table): expected no [initial_wave] beside tank.diameter_m: its cosine "
        "is a mode of a rectangle",
        "liquid.column_width_m = 0.2: expected no column_width_m beside tank.diameter_m: a dam "
        "stands at the left wall of a rectangle"})
    EXPECT_NE(all.find(wanted), std::string::npos) << all << "\nwanted: " << wanted;
}

TEST(Outline, HasNaturalModesToFit) {
  EXPECT_EQ(complaint_of(top + replaced(tables, "natural_modes = 0", "natural_modes = 2") + runs),
            "");
}

TEST(Outline, HasALinearTheoryOfUpTo150ModesWithoutGas) {
  const auto complaint_with = [](const std::string& keys) {
    return complaint_of(top + tables +
                        "[[run]]\nname = \"theory\"\nsolver = \"linear\"\n"
                        "valid_elevation_over_depth = 0.1\n" +
                        keys + runs);
  };
  EXPECT_EQ(complaint_with("modes = 40\n"), "");
  EXPECT_NE(complaint_with("modes = 1000\n")
                .find("run.modes = 1000: expected an integer from 1 to 150 beside "
                      "tank.diameter_m"),
            std::string::npos);
  EXPECT_NE(complaint_with("modes = 40\ntwo_layer = true\n").find("its theory has no gas"),
            std::string::npos);
}

TEST(Outline, HasFrictionBetweenWallsWhereTheMotionHasOneFrequency) {
  const std::string narrow =
      replaced(tables, "diameter_m = 1.0\n", "diameter_m = 1.0\nbreadth_m = 0.1\n");
  EXPECT_EQ(complaint_of(top + narrow + runs), "");
  const std::string two = replaced(
      narrow, "type = \"sine\"\namplitude_m = 0.02\nperiod_s = 1.1\n",
      "type = \"sines\"\nsines = [{ amplitude_m = 0.02, period_s = 1.3 }, { amplitude_m = 0.005, "
      "period_s = 0.7 }]\n");
  EXPECT_TRUE(complaint_of(top + two + runs)
                  .starts_with("trial.toml:7: tank.breadth_m = 0.1: expected no breadth_m beside "
                               "tank.diameter_m unless the motion has a single frequency"));
}

TEST(Outline, ExcludesSolversThatKnowRectanglesAlone) {
  for (const std::string solver : {"potential", "viscous_wave", "pysph"}) {
    const std::string message =
        complaint_of(top + tables + "[[run]]\nname = \"a\"\nsolver = \"" + solver + "\"\n" + runs);
    EXPECT_TRUE(message.starts_with("trial.toml:25: run.solver = \"" + solver +
                                    "\": expected one of sph, interfoam, interisofoam, "
                                    "compressible_interfoam, linear, record, external, stored, "
                                    "which know more than rectangles, beside tank.diameter_m"))
        << message;
  }
  EXPECT_NE(complaint_of(top + tables + "[[run]]\nname = \"a\"\nsolver = \"intrefoam\"\n" + runs)
                .find("nearest: interfoam"),
            std::string::npos);
}

TEST(Outline, IsTakenByTheSolversThatKnowMoreThanRectangles) {
  EXPECT_EQ(solvers_that_take_outlines(),
            (std::vector<std::string>{"sph", "interfoam", "interisofoam", "compressible_interfoam",
                                      "linear", "record", "external", "stored"}));
}

}  // namespace
}  // namespace slosh::outline_limits_test
