#include "verification/campaign/run_selection.hpp"

#include <gtest/gtest.h>

#include "verification/input/case_file_error.hpp"
#include "verification/tests/sample_case.hpp"

namespace slosh::run_selection_test {
namespace {

RunDefinition run_of(const std::string& name, decltype(RunDefinition::solver) solver,
                     bool quick = false) {
  return {.name = name, .solver = std::move(solver), .quick = quick, .where = {}};
}

SphRun particles(double spacing) {
  return {
      .scheme = "recommended", .particle_spacing = spacing, .surface_particle_spacing = spacing};
}

GateRow row_of(const std::string& candidate, const std::string& reference) {
  GateRow row{};
  row.candidate = candidate;
  row.reference = reference;
  row.metric = Metric::amplitude_error;
  return row;
}

// Two spacings, two meshes on a path, theory; the finer particles are judged by theory, the coarser
// ones by the finer mesh.
CaseDefinition tank() {
  CaseDefinition definition = sample_case();
  definition.name = "tank";
  definition.tags = {"surge", "small"};
  definition.runs = {run_of("theory", LinearRun{.modes = 5, .valid_elevation_over_depth = 1}, true),
                     run_of("fine", particles(0.01)), run_of("coarse", particles(0.02), true),
                     run_of("mesh_20", InterFoamRun{.cells_x = 20, .cells_z = 20}),
                     run_of("mesh_40", InterFoamRun{.cells_x = 40, .cells_z = 40})};
  definition.refinements = {{"mesh", RefinedNumber::mesh, {"mesh_20", "mesh_40"}}};
  definition.gate = {row_of("fine", "theory"), row_of("coarse", "mesh_40")};
  return definition;
}

std::vector<std::string> selected(const RunSelection& selection, const CaseDefinition& definition) {
  std::vector<std::string> names;
  for (const RunDefinition& run : definition.runs)
    if (is_selected(selection, definition, run)) names.push_back(run.name);
  return names;
}

using Names = std::vector<std::string>;

TEST(RunSelection, TakesAllRunsWhereNothingIsAskedFor) {
  EXPECT_EQ(selected({}, tank()), (Names{"theory", "fine", "coarse", "mesh_20", "mesh_40"}));
}

TEST(RunSelection, TakesTheReferenceOfARowWithItsCandidate) {
  EXPECT_EQ(selected({.only = {"tank/fine"}}, tank()), (Names{"theory", "fine"}));
}

TEST(RunSelection, TakesTheRunsThatAReferencesUncertaintyComesFrom) {
  EXPECT_EQ(selected({.only = {"t*k/coar*"}}, tank()), (Names{"coarse", "mesh_20", "mesh_40"}));
}

TEST(RunSelection, TakesTheWholeFamilyWhoseCostARowBounds) {
  CaseDefinition definition = tank();
  definition.gate[0].metric = Metric::cost_to_reach;
  EXPECT_EQ(selected({.only = {"tank/fine"}}, definition), (Names{"theory", "fine", "coarse"}));
}

TEST(RunSelection, TakesTheRunThatARowImprovesOn) {
  CaseDefinition definition = tank();
  definition.gate[0].improves_on = "coarse";
  EXPECT_EQ(selected({.only = {"tank/fine"}}, definition), (Names{"theory", "fine", "coarse"}));
  definition.runs.push_back(run_of("record", RecordRun{}));
  definition.gate[0].reference = "record";
  definition.refinements.push_back(
      {"spacing", RefinedNumber::particle_spacing, {"coarse", "idle"}});
  definition.runs.push_back(run_of("idle", particles(0.04)));
  EXPECT_EQ(selected({.only = {"tank/fine"}}, definition),
            (Names{"fine", "coarse", "record", "idle"}))
      << "its own numerical uncertainty counts too";
}

TEST(RunSelection, TakesTheRepeatsOfACandidate) {
  CaseDefinition definition = tank();
  for (const int seed : {1, 2}) {
    SphRun repeat = particles(0.01);
    repeat.start_disorder = 0.1;
    repeat.start_seed = seed;
    definition.runs.push_back(run_of("repeat_" + std::to_string(seed), repeat));
  }
  EXPECT_EQ(selected({.only = {"tank/fine"}}, definition),
            (Names{"theory", "fine", "repeat_1", "repeat_2"}));
}

TEST(RunSelection, TakesTheRepeatsAtTheBoundsOfAnInputWhereARowRestsOnAnExperiment) {
  CaseDefinition definition = tank();
  RunDefinition bound = run_of("coarse_density_lower", particles(0.02), true);
  bound.at_input = InputEnd{Input::density, -1, "coarse"};
  definition.runs.push_back(bound);
  const auto takes = [&](const RunSelection& selection) {
    return is_selected(selection, definition, bound);
  };
  EXPECT_FALSE(takes({}));
  EXPECT_TRUE(takes({.only = {"tank/coarse_density_lower"}}));
  definition.gate[0].metric = Metric::impact_arrival;
  definition.gate[0].reference = "";
  EXPECT_TRUE(takes({}));
  EXPECT_TRUE(takes({.only = {"tank/fine"}}));
  EXPECT_FALSE(takes({.only = {"tank/coarse"}}));
  EXPECT_FALSE(takes({.quick = true}));  // the row's candidate is not quick
  definition.gate[0].candidate = "coarse";
  EXPECT_TRUE(takes({.quick = true}));
  definition.gate[0].kind = RowKind::regression;
  EXPECT_FALSE(takes({.quick = true}));
  definition.gate[0].kind = RowKind::validation;
  definition.gate[0].metric = Metric::peak_ks_p_value;
  EXPECT_FALSE(takes({.quick = true}));
}

TEST(RunSelection, TakesWhatTellsTheInputsOfARowThatRestsOnAnExperiment) {
  CaseDefinition definition = tank();
  definition.runs.push_back(run_of("record", RecordRun{}));
  definition.runs.push_back(run_of("slow", particles(0.04)));
  definition.gate[0].reference = "record";
  EXPECT_EQ(selected({.only = {"tank/fine"}}, definition), (Names{"fine", "record"}));
  definition.inputs = {{Input::amplitude, 0.001, "a ruler", "slow"}};
  EXPECT_EQ(selected({.only = {"tank/fine"}}, definition),
            (Names{"theory", "fine", "record", "slow"}));
  EXPECT_EQ(selected({.only = {"tank/coarse"}}, definition),
            (Names{"coarse", "mesh_20", "mesh_40"}));
  definition.inputs = {{Input::kinematic_viscosity, 1e-7, "a table", "slow"}};
  EXPECT_EQ(selected({.only = {"tank/fine"}}, definition), (Names{"fine", "record", "slow"}));
  definition.gate[0].kind = RowKind::regression;
  EXPECT_EQ(selected({.only = {"tank/fine"}}, definition), (Names{"fine", "record"}));
}

TEST(RunSelection, TakesAReferenceAloneWithoutTheCandidatesThatItJudges) {
  EXPECT_EQ(selected({.only = {"tank/theory"}}, tank()), Names{"theory"});
}

TEST(RunSelection, LeavesOutOfAQuickFormWhatIsNotQuickEvenWhereItIsNamedOrNeeded) {
  EXPECT_EQ(selected({.quick = true}, tank()), (Names{"theory", "coarse"}));
  EXPECT_EQ(selected({.quick = true, .only = {"tank/fine", "tank/coarse"}}, tank()),
            Names{"coarse"});
}

TEST(RunSelection, AsksForAPatternAndATag) {
  EXPECT_EQ(selected({.only = {"tank"}, .tags = {"small", "roll"}}, tank()).size(), 5u);
  EXPECT_EQ(selected({.only = {"tank"}, .tags = {"roll"}}, tank()).size(), 0u);
  EXPECT_EQ(selected({.only = {"other"}, .tags = {"small"}}, tank()).size(), 0u);
}

TEST(RunSelection, LetsNoStarReachAcrossASlash) {
  EXPECT_EQ(selected({.only = {"*/fine"}}, tank()), (Names{"theory", "fine"}));
  EXPECT_EQ(selected({.only = {"tank*fine"}}, tank()).size(), 0u);
}

TEST(RunSelection, TakesProblemsByNameAndNoneByTag) {
  EXPECT_TRUE(names_problem({}, "rigid_rotation"));
  EXPECT_TRUE(names_problem({.only = {"tank", "rigid*"}}, "rigid_rotation"));
  EXPECT_FALSE(names_problem({.only = {"tank"}}, "rigid_rotation"));
  EXPECT_FALSE(names_problem({.tags = {"small"}}, "rigid_rotation"));
}

std::string refusal(const RunSelection& selection) {
  const std::vector<CaseDefinition> cases{tank()};
  try {
    require_matches(selection, {cases, {"rigid_rotation"}});
  } catch (const CaseFileError& error) {
    return error.what();
  }
  return "";
}

TEST(RunSelection, RefusesWhatMatchesNothingAndNamesTheNearest) {
  EXPECT_EQ(refusal({.only = {"tank", "tank/f*", "rigid*"}, .tags = {"small"}}), "");
  EXPECT_EQ(refusal({.only = {"tunk"}}),
            "tunk matches nothing: expected a pattern that matches a name or a CASE/RUN; nearest: "
            "tank, rigid_rotation");
  EXPECT_NE(refusal({.only = {"tank/fin"}}).find("nearest: tank/fine, "), std::string::npos);
  EXPECT_NE(refusal({.only = {"tanc/fine"}}).find("nearest: tank"), std::string::npos);
  EXPECT_EQ(refusal({.tags = {"smal"}}),
            "smal matches nothing: expected a tag of a case; nearest: small, surge");
}

TEST(RunSelection, TellsItselfInWordsAndAsTheOptionsThatRepeatIt) {
  const RunSelection selection{.quick = true, .only = {"a*", "b/c"}, .tags = {"surge"}};
  EXPECT_EQ(selection_text(selection), "only a*, b/c; tagged surge");
  EXPECT_EQ(selection_options(selection), " --quick --only 'a*' --only 'b/c' --tag 'surge'");
  EXPECT_EQ(selection_text({}) + selection_options({}), "");
}

}  // namespace
}  // namespace slosh::run_selection_test
