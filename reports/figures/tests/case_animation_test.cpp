// The animation of a case: its runs and its moments.
#include <gtest/gtest.h>

#include "verification/tests/figure_results.hpp"

namespace slosh::case_animation_test {
namespace {

using Names = std::vector<std::string>;

CaseDefinition animated_case() {
  CaseDefinition definition = surge_case();
  definition.animation_times = {1, 1.5, 2};
  return definition;
}

CaseRuns animated_runs(const Names& names) {
  CaseRuns runs = surge_runs();
  for (const std::string& name : names)
    for (const double time : {1.0, 1.5, 2.0})
      runs.results.at(name).snapshots.push_back(snapshot_at(time, 100));
  return runs;
}

// The last of the case's fields; the test fails where it is no animation.
reports::FieldFigure animation_of(const CaseDefinition& definition, const CaseRuns& runs) {
  const auto fields = case_fields(assess(definition, runs));
  if (fields.empty() || !fields.back().is_animation) {
    ADD_FAILURE() << "no animation";
    return {};
  }
  return fields.back();
}

Names labels_of(const reports::FieldFigure& figure) {
  Names labels;
  for (const reports::FieldPanel& panel : figure.panels) labels.push_back(panel.label);
  return labels;
}

bool says(const reports::FieldFigure& figure, const std::string& sentence) {
  return figure.caption.find(sentence) != std::string::npos;
}

TEST(CaseAnimation, IsTheLastFieldAndHasTheFinestRunOfEachSolverAtEachMoment) {
  CaseDefinition definition = animated_case();
  definition.snapshot_times = {1, 2};
  const CaseRuns runs = animated_runs({"particles", "coarse_mesh", "fine_mesh"});
  const auto fields = case_fields(assess(definition, runs));
  ASSERT_EQ(fields.size(), 2u);
  EXPECT_FALSE(fields[0].is_animation);
  EXPECT_EQ(fields[0].panels.size(), 4u);  // of the two snapshot times alone
  const reports::FieldFigure& animation = fields[1];
  EXPECT_EQ(animation.id, "small_surge-animation");
  EXPECT_TRUE(animation.is_animation);
  EXPECT_EQ(animation.columns, 2);
  EXPECT_EQ(labels_of(animation),
            (Names{"particles, t = 1 s", "fine_mesh, t = 1 s", "particles, t = 1.5 s",
                   "fine_mesh, t = 1.5 s", "particles, t = 2 s", "fine_mesh, t = 2 s"}));
  EXPECT_TRUE(says(animation, "Animation of 3 moments, 0.5 s apart"));
}

TEST(CaseAnimation, KeepsARunThatLacksMomentsAndTellsSo) {
  CaseRuns runs = animated_runs({"particles", "fine_mesh"});
  runs.results.at("fine_mesh").snapshots.pop_back();
  const reports::FieldFigure animation = animation_of(animated_case(), runs);
  EXPECT_EQ(animation.columns, 2);
  EXPECT_TRUE(animation.panels.at(5).x.empty());
  EXPECT_TRUE(says(animation, " fine_mesh recorded 2 of these moments."));
  EXPECT_FALSE(says(animation, "particles recorded"));
}

TEST(CaseAnimation, TellsOfASolverThatRecordedNone) {
  const reports::FieldFigure animation =
      animation_of(animated_case(), animated_runs({"particles"}));
  EXPECT_EQ(animation.columns, 1);
  EXPECT_TRUE(says(animation, " fine_mesh recorded none of them."));
}

TEST(CaseAnimation, LeavesOutAMomentThatNoRunRecorded) {
  CaseRuns runs = animated_runs({"particles", "fine_mesh"});
  for (const std::string run : {"particles", "fine_mesh"})
    runs.results.at(run).snapshots.erase(runs.results.at(run).snapshots.begin());
  EXPECT_EQ(animation_of(animated_case(), runs).panels.size(), 4u);
  for (const std::string run : {"particles", "fine_mesh"})
    runs.results.at(run).snapshots.pop_back();
  EXPECT_TRUE(case_fields(assess(animated_case(), runs)).empty()) << "one moment is no animation";
}

}  // namespace
}  // namespace slosh::case_animation_test
