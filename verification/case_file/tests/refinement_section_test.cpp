// [[refinement]] of a case file: runs that differ in one number only, and what is refused.
#include <gtest/gtest.h>

#include "verification/case_file/tests/refusals.hpp"
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

TEST(RefinementSection, ReadsAPathOfRunsThatAreAlikeButForTheirSpacing) {
  const CaseDefinition definition =
      read_text(refined("particle_spacing", "\"coarse\", \"fine\", \"finer\""));
  ASSERT_EQ(definition.refinements.size(), 1U);
  EXPECT_EQ(definition.refinements[0].name, "path");
  EXPECT_EQ(definition.refinements[0].number, RefinedNumber::particle_spacing);
  EXPECT_EQ(definition.refinements[0].runs, (std::vector<std::string>{"coarse", "fine", "finer"}));
}

std::string external(const std::string& name, const std::string& method,
                     const std::string& spacing) {
  return "[[run]]\nname = \"" + name +
         "\"\nsolver = \"external\"\ncommand = [\"true\", \"{particle_spacing_m}\"]\nmethod = \"" +
         method + "\"\nparticle_spacing_m = " + spacing +
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
  expect_refusals(valid_text + path("\"mine_1\", \"mine_2\"", "particle_spacing"), R"(
refinement.runs = ["mine_1", "theirs"] -> refinement.runs = (an array): expected ... mine_1 and
  theirs differ in others
refinement.runs = ["fine", "mine_1"] -> refinement.runs = (an array): expected ... fine and mine_1
  differ in others
refinement.number = "courant_number" -> refinement.runs = (an array): expected ... SPH runs of this
  case; mine_1 is not one
)");
}

TEST(RefinementSection, RefusesRunsThatAreNoPath) {
  expect_refusals(refined("particle_spacing", "\"fine\", \"finer\""), R"(
refinement.runs = ["fine", "thick"] -> refinement.runs = (an array): expected ... fine and thick
  differ in others
refinement.number = "courant_number" -> refinement.runs = (an array): expected ... fine and finer
  differ in others
refinement.runs = ["fine", "mesh"] -> refinement.runs = (an array): expected ... runs with
  particle_spacing_m of this case; mesh is not one
refinement.number = "courant_number" & refinement.runs = ["fine", "mesh"] -> refinement.runs = (an
  array): expected ... SPH runs of this case; mesh is not one
refinement.number = "mesh" & refinement.runs = ["mesh", "fine"] -> refinement.runs = (an array):
  expected ... OpenFOAM runs of this case; fine is not one
refinement.runs = ["fine", "nobody"] -> refinement.runs = (an array): expected ... nobody is not
refinement.runs = ["fine", "measured"] -> refinement.runs = (an array): expected ... runs with
  expected_speed = "estimate": the speed of sound of measured, from a coarse run, would differ
refinement.runs = ["fine"] -> refinement.runs = (an array): expected ... two runs or more
refinement.runs = ["fine", "fine"] -> refinement.runs = (an array): expected ... each run once; fine
  is there twice
refinement.number = "particle_spacin": expected ... nearest: particle_spacing
)");
}

}  // namespace
}  // namespace slosh::refinement_section_test
