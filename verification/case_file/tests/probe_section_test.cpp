// [[probe]] and wall_forces.
#include <gtest/gtest.h>

#include "verification/case/quantities.hpp"
#include "verification/case_file/tests/refusals.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::probe_section_test {
namespace {

const std::string probe = "[[probe]]\nname = \"middle\"\nx_m = 1.0\nz_m = 0.2\n[comparison]\n";

TEST(ProbeSection, GivesAPlaceInTheTank) {
  const CaseDefinition definition = read_text(edited({"[comparison]\n", probe}));
  ASSERT_EQ(definition.probes.size(), 1u);
  EXPECT_EQ(definition.probes[0].name, "middle");
  EXPECT_EQ(definition.probes[0].x, 1);
  EXPECT_EQ(definition.probes[0].z, 0.2);
}

TEST(ProbeSection, RefusesAPlaceOutsideTheTankAndANameGivenTwice) {
  const std::string one = "[[probe]]\nname = \"a\"\nx_m = 1\nz_m = 0.2\n";
  expect_refusals(valid_text + one, R"(
probe.x_m = 2.1: expected a number from 0 to the tank's length (2), in m from the left wall
probe.z_m = -0.2: expected a number from 0 to the tank's height (1), in m from the bottom
wall_forces = ["front"] -> wall_forces = (an array): expected a list of walls (left, right, bottom,
  roof), each once
wall_forces = ["left", "left"] -> wall_forces = (an array): expected a list of walls
)");
  expect_refusals(valid_text + one + one,
                  R"(-> probe.name = "a": expected a name that no other probe)");
  expect_refusals(valid_text + one +
                      "[[obstacle]]\nname = \"block\"\nleft_m = 0.9\nright_m = "
                      "1.1\nbottom_m = 0\ntop_m = 0.3\n",
                  R"(
-> obstacle.name = "block": expected an obstacle elsewhere: it holds the probe a at (1, 0.2) m
)");
}

TEST(WallForcesKey, NamesTheWallsWhoseForcesAreCompared) {
  const CaseDefinition definition =
      read_text(edited({"[tank]\n", "wall_forces = [\"right\", \"bottom\"]\n[tank]\n"}));
  EXPECT_EQ(definition.wall_forces, (std::vector<Wall>{Wall::right, Wall::bottom}));
  const std::vector<std::string> compared = compared_quantities(definition);
  EXPECT_EQ(std::count(compared.begin(), compared.end(), "force_x@right"), 1);
  EXPECT_EQ(std::count(compared.begin(), compared.end(), "force_z@bottom"), 1);
  EXPECT_EQ(std::count(compared.begin(), compared.end(), "force_x@left"), 0);
}

}  // namespace
}  // namespace slosh::probe_section_test
