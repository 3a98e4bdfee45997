// [[probe]] and wall_forces.
#include <gtest/gtest.h>

#include "verification/case/quantities.hpp"
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
  const auto with = [](const std::string& tables) {
    return complaint_about({"[comparison]\n", tables + "[comparison]\n"});
  };
  EXPECT_NE(with("[[probe]]\nname = \"a\"\nx_m = 2.1\nz_m = 0.2\n")
                .find("x_m = 2.1: expected a number from 0 to the tank's length (2), in m from the "
                      "left wall"),
            std::string::npos);
  EXPECT_NE(
      with("[[probe]]\nname = \"a\"\nx_m = 1\nz_m = -0.2\n")
          .find("z_m = -0.2: expected a number from 0 to the tank's height (1), in m from the "
                "bottom"),
      std::string::npos);
  const std::string one = "[[probe]]\nname = \"a\"\nx_m = 1\nz_m = 0.2\n";
  EXPECT_NE(with(one + one).find("expected a name that no other probe has"), std::string::npos);
  EXPECT_NE(with("[[obstacle]]\nname = \"block\"\nleft_m = 0.9\nright_m = 1.1\nbottom_m = 0\n"
                 "top_m = 0.3\n" +
                 one)
                .find("an obstacle elsewhere: it holds the probe a at (1, 0.2) m"),
            std::string::npos);
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

TEST(WallForcesKey, RefusesWhatIsNoWallAndAWallNamedTwice) {
  for (const char* walls : {"[\"front\"]", "[\"left\", \"left\"]"}) {
    const std::string message =
        complaint_about({"[tank]\n", std::string("wall_forces = ") + walls + "\n[tank]\n"});
    EXPECT_NE(message.find("expected a list of walls (left, right, bottom, roof), each once"),
              std::string::npos)
        << message;
  }
}

}  // namespace
}  // namespace slosh::probe_section_test
