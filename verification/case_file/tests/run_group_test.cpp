// Runs that are written as a group.
#include "verification/case_file/groups/run_group.hpp"

#include <gtest/gtest.h>

#include "verification/case_file/spacing_study.hpp"
#include "verification/case_file/tests/refusals.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::run_group_test {
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

}  // namespace
}  // namespace slosh::run_group_test
