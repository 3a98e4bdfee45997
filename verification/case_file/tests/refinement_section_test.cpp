// [[refinement]] of a case file: runs that differ in one number only, and what is refused.
#include <gtest/gtest.h>

#include "verification/tests/trial_case.hpp"

namespace slosh::refinement_section_test {
namespace {

const std::string runs = R"([[run]]
name = "fine"
solver = "sph"
scheme = "any"
particle_spacing_m = 0.01
[[run]]
name = "finer"
solver = "sph"
scheme = "any"
particle_spacing_m = 0.005
[[run]]
name = "thick"
solver = "sph"
scheme = "any"
particle_spacing_m = 0.005
artificial_viscosity = 0.2
[[run]]
name = "measured"
solver = "sph"
scheme = "any"
particle_spacing_m = 0.005
expected_speed = "coarse_run"
)";

std::string refined(const std::string& number, const std::string& names) {
  return valid_text + runs + "[[refinement]]\nname = \"path\"\nnumber = \"" + number +
         "\"\nruns = [" + names + "]\n";
}

std::string complaint_about(const std::string& number, const std::string& names) {
  const Workspace workspace;
  return complaint(workspace.write("trial.toml", refined(number, names)));
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(RefinementSection, ReadsAPathOfRunsThatAreAlikeButForTheirSpacing) {
  const CaseDefinition definition =
      read_text(refined("particle_spacing", "\"coarse\", \"fine\", \"finer\""));
  ASSERT_EQ(definition.refinements.size(), 1U);
  EXPECT_EQ(definition.refinements[0].name, "path");
  EXPECT_EQ(definition.refinements[0].number, RefinedNumber::particle_spacing);
  EXPECT_EQ(definition.refinements[0].runs, (std::vector<std::string>{"coarse", "fine", "finer"}));
}

TEST(RefinementSection, RefusesRunsThatDifferInMoreThanTheNumber) {
  const std::string said = complaint_about("particle_spacing", "\"fine\", \"thick\"");
  EXPECT_TRUE(holds(said, "fine and thick differ in others")) << said;
  const std::string other = complaint_about("courant_number", "\"fine\", \"finer\"");
  EXPECT_TRUE(holds(other, "fine and finer differ in others")) << other;
}

std::string external(const std::string& name, const std::string& method,
                     const std::string& spacing) {
  return "[[run]]\nname = \"" + name +
         "\"\nsolver = \"external\"\ncommand = [\"true\"]\nmethod = \"" + method +
         "\"\nparticle_spacing_m = " + spacing +
         "\n[[run.series]]\nquantity = \"elevation@right\"\nfile = \"a.csv\"\nformat = \"csv\"\n"
         "column = \"eta\"\ntime_column = \"t\"\n";
}

TEST(RefinementSection, ReadsAPathOfAnExternalProgramsMethodAndOfNothingElseBesideIt) {
  const std::string programs = external("mine_1", "mine", "0.02") +
                               external("mine_2", "mine", "0.01") +
                               external("theirs", "theirs", "0.01");
  const auto path = [&](const std::string& names, const std::string& number) {
    return programs + refined(number, names).substr(valid_text.size());
  };
  const CaseDefinition definition =
      read_text(valid_text + path("\"mine_1\", \"mine_2\"", "particle_spacing"));
  EXPECT_EQ(definition.refinements.at(0).runs, (std::vector<std::string>{"mine_1", "mine_2"}));
  const auto complaint_about = [&](const std::string& names, const std::string& number) {
    const Workspace workspace;
    return complaint(workspace.write("trial.toml", valid_text + path(names, number)));
  };
  EXPECT_TRUE(holds(complaint_about("\"mine_1\", \"theirs\"", "particle_spacing"),
                    "mine_1 and theirs differ in others"));
  EXPECT_TRUE(holds(complaint_about("\"fine\", \"mine_1\"", "particle_spacing"),
                    "fine and mine_1 differ in others"));
  EXPECT_TRUE(holds(complaint_about("\"mine_1\", \"mine_2\"", "courant_number"),
                    "SPH runs of this case; mine_1 is not one"));
}

TEST(RefinementSection, RefusesWhatIsNoRunOfTheSolver) {
  EXPECT_TRUE(holds(complaint_about("particle_spacing", "\"fine\", \"mesh\""),
                    "runs with particle_spacing_m of this case; mesh is not one"));
  EXPECT_TRUE(holds(complaint_about("courant_number", "\"fine\", \"mesh\""),
                    "SPH runs of this case; mesh is not one"));
  EXPECT_TRUE(holds(complaint_about("mesh", "\"mesh\", \"fine\""),
                    "OpenFOAM runs of this case; fine is not one"));
  EXPECT_TRUE(holds(complaint_about("particle_spacing", "\"fine\", \"nobody\""), "nobody is not"));
}

TEST(RefinementSection, RefusesARunWhoseSpeedOfSoundFollowsACoarseRun) {
  EXPECT_TRUE(holds(complaint_about("particle_spacing", "\"fine\", \"measured\""),
                    "runs with expected_speed = \"estimate\": the speed of sound of measured, from "
                    "a coarse run, would differ"));
}

TEST(RefinementSection, RefusesAPathThatIsNone) {
  EXPECT_TRUE(holds(complaint_about("particle_spacing", "\"fine\""), "two runs or more"));
  EXPECT_TRUE(holds(complaint_about("particle_spacing", "\"fine\", \"fine\""),
                    "each run once; fine is there twice"));
  EXPECT_TRUE(holds(complaint_about("particle_spacin", "\"fine\", \"finer\""),
                    "nearest: particle_spacing"));
}

}  // namespace
}  // namespace slosh::refinement_section_test
