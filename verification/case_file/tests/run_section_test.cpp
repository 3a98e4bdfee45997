// Runs that are written as a group.
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "verification/case_file/key_table.hpp"
#include "verification/case_file/made_cases.hpp"
#include "verification/case_file/tests/refusals.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::run_section_test {
namespace {

const std::string group = R"([[run]]
name = "ours_{particle_spacing_mm}mm"
solver = "sph"
scheme = "any"
particle_spacing_m = [0.025, 0.0125]
quick = ["*_25mm"]
)";

CaseDefinition with_group(const std::string& text) { return read_text(valid_text + text); }

TEST(RunGroup, HasARunForEachListedValueWithTheKeysOfTheGroup) {
  const CaseDefinition definition = with_group(group);
  ASSERT_EQ(definition.runs.size(), 5u);
  const RunDefinition &coarse = definition.runs[3], &fine = definition.runs[4];
  EXPECT_EQ(coarse.name, "ours_25mm");
  EXPECT_EQ(fine.name, "ours_12p5mm");
  EXPECT_EQ(std::get<SphRun>(fine.solver).scheme, "any");
  EXPECT_EQ(std::get<SphRun>(fine.solver).particle_spacing, 0.0125);
  EXPECT_TRUE(coarse.quick);
  EXPECT_FALSE(fine.quick);
}

TEST(RunGroup, NamesItsRunsByAnyKeyAndByNumbersOfAsManyDigitsAsTheFileSays) {
  const CaseDefinition definition = with_group(
      "[[run]]\nname = \"{scheme}_{start_seed:02}\"\nsolver = \"sph\"\nscheme = [\"a\", \"b\"]\n"
      "particle_spacing_m = 0.02\nstart_disorder = 0.1\nstart_seed = [7, 12]\n");
  std::vector<std::string> names;
  for (const RunDefinition& run : definition.runs) names.push_back(run.name);
  EXPECT_EQ(names,
            (std::vector<std::string>{"theory", "coarse", "mesh", "a_07", "a_12", "b_07", "b_12"}));
}

TEST(RunGroup, HasMembersOfAnEnsembleForEachOfItsRuns) {
  const CaseDefinition definition = with_group(group + "start_disorder = 0.1\nrepeats = 2\n");
  EXPECT_EQ(definition.runs.size(), 7u);
  EXPECT_EQ(definition.runs[4].ensemble, "ours_25mm");
}

TEST(RunGroup, IsRefusedWhereAListHasNoNameOfItsOwnOrAPatternMeansNothing) {
  std::string seeds = "0";
  for (int seed = 1; seed < 600; ++seed) seeds += ", " + std::to_string(seed);
  expect_refusals(valid_text + group, R"(
run.quick is missing & run.name = "ours_fine" -> run.particle_spacing_m = (an array): expected
run.name = "{scheme}_25mm" -> run.name = "any_25mm": expected a name that no other run has
run.name = "ours_{spacing}mm": expected ... there is no spacing
run.name = "ours_{scheme:3}mm": expected ... {KEY:01} to {KEY:09}
run.quick = ["*_30mm"] -> run.quick = "*_30mm": expected a name or a pattern of a run
run.particle_spacing_m = [0.025, -1] -> run.particle_spacing_m = -1: expected
run.start_disorder = 0.1 & run.start_seed = [)" +
                                          seeds + R"(] -> run.start_seed = (an array):
  expected lists of at most 1000 combinations
)");
}

TEST(RunGroup, GivesARunToASpacingStudy) {
  const CaseDefinition definition = with_group(group);
  const std::string text = spacing_study_text(definition, {.candidate = "ours_25mm",
                                                           .family = "",
                                                           .spacings = {0.05, 0.04, 0.02},
                                                           .reference = "theory"})
                               .text;
  const CaseDefinition study = read_text(text);
  EXPECT_EQ(study.runs.size(), 4u);
  EXPECT_EQ(study.runs[1].name, "ours_25mm_at_50mm");
}

// [[refinement]] of a case file: runs that differ in one number only, and what is refused.

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

// The keys that a [[run]] may have, by its solver: each key of another solver is refused.
TEST(SolverKeys, OfAnotherSolverAreRefused) {
  const Workspace workspace;
  std::size_t pairs = 0;
  for (const KeyTable& form : case_key_tables())
    for (const std::string& solver : form.solvers) {
      std::set<std::string> others;
      for (const KeyTable& other : case_key_tables())
        if (!other.solvers.empty())
          for (const std::string& key : other.names()) others.insert(key);
      for (const std::string& key : form.names()) others.erase(key);
      others.erase("experiment");  // which makes a record the other
      for (const std::string& key : others) {
        const std::string message = complaint(workspace.write(
            "trial.toml", valid_text + "[[run]]\nname = \"x\"\nsolver = \"" + solver + "\"\n" +
                              (form.id == "run.experiment" ? "experiment = \"a.csv\"\n" : "") +
                              key + " = 1\n"));
        EXPECT_TRUE(holds(message, "run." + key + " = 1: expected only these keys here: name"))
            << solver << ": " << message;
        ++pairs;
      }
    }
  EXPECT_GT(pairs, 150u);
}

TEST(SolverKeys, AMisspeltSolverIsToldByTheNearestKey) {
  const std::string message = complaint_about({"solver = \"interfoam\"", "solvr = \"interfoam\""});
  EXPECT_TRUE(begins(message, "trial.toml:49: run.solvr = \"interfoam\": expected only"));
  EXPECT_TRUE(message.ends_with("nearest known key: solver")) << message;
}

}  // namespace
}  // namespace slosh::run_section_test
