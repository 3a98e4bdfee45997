// The flow fields at a case's snapshot times, and its animation: their runs and their moments.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "reports/pages/write_report.hpp"
#include "reports/summary/report_sections.hpp"
#include "verification/tests/figure_results.hpp"

namespace slosh::case_fields_test {
namespace {

using Names = std::vector<std::string>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Roll of 0.1 rad at 1 s, none at 2 s.
CaseDefinition rolling_case() {
  CaseDefinition definition = surge_case();
  definition.motion = {{}, RollDefinition{SineMotion{0.1, std::numbers::pi / 2}, 0.45, 0.1}};
  definition.snapshot_times = {1, 2};
  return definition;
}

CaseRuns runs_with_snapshots(const Names& names, const std::vector<double>& times) {
  CaseRuns runs = surge_runs();
  for (const std::string& name : names)
    for (const double time : times)
      runs.results.at(name).snapshots.push_back(snapshot_at(time, name == "particles" ? 100 : 50));
  return runs;
}

Names panel_labels(const reports::FieldFigure& figure) {
  Names names;
  for (const reports::FieldPanel& panel : figure.panels) names.push_back(panel.label);
  return names;
}

TEST(CaseFields, HaveARowForAMomentAndAColumnForASolver) {
  const CaseRuns runs = runs_with_snapshots({"particles", "coarse_mesh", "fine_mesh"}, {1, 2});
  const auto fields = case_fields({rolling_case(), runs, {}, {}, {}});
  ASSERT_EQ(fields.size(), 1u);
  EXPECT_EQ(fields[0].id, "small_surge-fields-1");
  EXPECT_EQ(fields[0].title, "Pressure and velocity at 1 and 2 s");
  EXPECT_EQ(fields[0].columns, 2);
  EXPECT_EQ(panel_labels(fields[0]),
            (Names{"particles, t = 1 s, roll 5.73°", "fine_mesh, t = 1 s, roll 5.73°",
                   "particles, t = 2 s, roll 0.00°", "fine_mesh, t = 2 s, roll 0.00°"}));
  EXPECT_EQ(fields[0].value_range.first, fields[0].value_range.second);
  EXPECT_TRUE(case_fields({rolling_case(), surge_runs(), {}, {}, {}}).empty());
  EXPECT_TRUE(case_fields({surge_case(), surge_runs(), {}, {}, {}}).empty());
}

TEST(CaseFields, ShowPressureAndVelocityInTheTankAsItIsTurned) {
  const CaseRuns runs = runs_with_snapshots({"particles"}, {1});
  const auto fields = case_fields({rolling_case(), runs, {}, {}, {}});
  ASSERT_EQ(fields.size(), 1u);
  ASSERT_EQ(fields[0].panels.size(), 1u);
  const reports::FieldPanel& panel = fields[0].panels[0];
  EXPECT_NEAR(panel.angle, 0.1, 1e-12);
  EXPECT_EQ(panel.axis_x, 0.45);
  EXPECT_EQ(panel.axis_z, 0.1);
  EXPECT_EQ(panel.tank_length, 1);
  EXPECT_EQ(panel.tank_height, 1);
  EXPECT_EQ(panel.point_width, 0.01);
  EXPECT_EQ(panel.point_height, 0.02);
  const FieldSnapshot snapshot = snapshot_at(1, 100);
  EXPECT_EQ(panel.x, snapshot.x);
  EXPECT_EQ(panel.z, snapshot.z);
  EXPECT_EQ(panel.value, snapshot.pressure);
  EXPECT_EQ(panel.arrow_x, snapshot.x);
  EXPECT_EQ(panel.arrow_z, snapshot.z);
  EXPECT_EQ(panel.arrow_u, snapshot.velocity_x);
  EXPECT_EQ(panel.arrow_w, snapshot.velocity_z);
  EXPECT_EQ(fields[0].title, "Pressure and velocity at 1 s");
}

TEST(CaseFields, OfATankThatDoesNotRollStandLevelInItsOutline) {
  CaseDefinition definition = surge_case();
  definition.snapshot_times = {1};
  const CaseRuns runs = runs_with_snapshots({"particles"}, {1});
  const reports::FieldPanel level = case_fields({definition, runs, {}, {}, {}}).at(0).panels.at(0);
  EXPECT_EQ(level.angle, 0);
  EXPECT_EQ(level.label, "particles, t = 1 s");
  EXPECT_TRUE(level.outline.empty());
  definition.tank.outline = {{0.2, 0}, {0.8, 0}, {1, 1}, {0, 1}};
  definition.natural_modes = 0;
  const reports::FieldPanel panel = case_fields({definition, runs, {}, {}, {}}).at(0).panels.at(0);
  ASSERT_EQ(panel.outline.size(), 4u);
  EXPECT_EQ(panel.outline[1].x, 0.8);
  EXPECT_EQ(panel.outline[2].z, 1);
  EXPECT_EQ(panel.tank_length, 1);
}

TEST(CaseFields, LeaveThePlaceOfASnapshotThatIsMissingEmpty) {
  CaseRuns runs = runs_with_snapshots({"particles", "fine_mesh"}, {1, 2});
  runs.results.at("particles").snapshots.pop_back();
  runs.results.at("fine_mesh").snapshots[0].pressure[0] = nan;
  const CaseAssessment assessment = assess(rolling_case(), runs);
  const auto fields = case_fields(assessment);
  ASSERT_EQ(fields.size(), 1u);
  ASSERT_EQ(fields[0].panels.size(), 4u);
  EXPECT_EQ(fields[0].panels[2].label, "particles, t = 2 s, roll 0.00°, not recorded");
  EXPECT_TRUE(fields[0].panels[2].x.empty());
  EXPECT_EQ(fields[0].panels[3].value, (std::vector<double>{50, 100}));
  const CampaignDefinition campaign{"surges", "Surges", "none", "", {}, "", "surges.toml"};
  const reports::Report report = campaign_report(campaign, false, "", {assessment});
  EXPECT_NO_THROW(reports::check_report(report));
  EXPECT_EQ(std::count_if(report.sections.begin(), report.sections.end(),
                          [](const reports::Section& section) { return !section.fields.empty(); }),
            1);
}

TEST(CaseFields, AreCutWhereTheyHaveTooManyMoments) {
  CaseDefinition definition = rolling_case();
  definition.snapshot_times = {1, 2, 3, 4, 5, 6};
  const auto fields =
      case_fields({definition,
                   runs_with_snapshots({"particles", "fine_mesh"}, {1, 2, 3, 4, 5, 6}),
                   {},
                   {},
                   {}});
  ASSERT_EQ(fields.size(), 2u);
  EXPECT_EQ(fields[0].panels.size(), 6u);
  EXPECT_EQ(fields[1].panels.size(), 6u);
  EXPECT_EQ(fields[1].title, "Pressure and velocity from 4 to 6 s (2 of 2)");
  EXPECT_EQ(fields[1].id, "small_surge-fields-2");
}

TEST(CaseFields, AreCutWhereTheyHaveTooManyColumns) {
  CaseDefinition definition = rolling_case();
  CaseRuns runs = runs_with_snapshots({"particles"}, {1, 2});
  for (const std::string scheme : {"li2010", "zhao2021_fixed", "zhao2021_moving", "delta_sph"}) {
    definition.runs.push_back(sample_run(SphRun{scheme, 0.01, 0.01}));
    definition.runs.back().name = scheme;
    runs.results[scheme] = runs.results.at("particles");
    runs.status[scheme] = {RunState::finished, ""};
  }
  for (FieldSnapshot& one : runs.results.at("delta_sph").snapshots)
    for (double& pressure : one.pressure) pressure *= 10;
  const auto fields = case_fields({definition, runs, {}, {}, {}});
  ASSERT_EQ(fields.size(), 2u);
  EXPECT_EQ(fields[0].value_range, fields[1].value_range);
  EXPECT_EQ(fields[0].value_range.second, 2000);  // of delta_sph, which stands in the second
  EXPECT_EQ(fields[0].columns, 2);
  EXPECT_EQ(fields[0].panels.at(1).label, "li2010, t = 1 s, roll 5.73°");
  EXPECT_EQ(fields[1].columns, 3);
  EXPECT_EQ(fields[1].panels.at(5).label, "delta_sph, t = 2 s, roll 0.00°");
}

CaseDefinition animated_case() {
  CaseDefinition definition = surge_case();
  definition.animation_times = {1, 1.5, 2};
  return definition;
}

CaseRuns animated_runs(const Names& names) { return runs_with_snapshots(names, {1, 1.5, 2}); }

// The last of the case's fields; the test fails where it is no animation.
reports::FieldFigure animation_of(const CaseDefinition& definition, const CaseRuns& runs) {
  const auto fields = case_fields({definition, runs, {}, {}, {}});
  if (fields.empty() || !fields.back().is_animation) {
    ADD_FAILURE() << "no animation";
    return {};
  }
  return fields.back();
}

bool says(const reports::FieldFigure& figure, const std::string& sentence) {
  return figure.caption.find(sentence) != std::string::npos;
}

TEST(CaseAnimation, IsTheLastFieldAndHasTheFinestRunOfEachSolverAtEachMoment) {
  CaseDefinition definition = animated_case();
  definition.snapshot_times = {1, 2};
  const CaseRuns runs = animated_runs({"particles", "coarse_mesh", "fine_mesh"});
  const auto fields = case_fields({definition, runs, {}, {}, {}});
  ASSERT_EQ(fields.size(), 2u);
  EXPECT_FALSE(fields[0].is_animation);
  EXPECT_EQ(fields[0].panels.size(), 4u);  // of the two snapshot times alone
  const reports::FieldFigure& animation = fields[1];
  EXPECT_EQ(animation.id, "small_surge-animation");
  EXPECT_TRUE(animation.is_animation);
  EXPECT_EQ(animation.columns, 2);
  EXPECT_EQ(panel_labels(animation),
            (Names{"particles, t = 1 s", "fine_mesh, t = 1 s", "particles, t = 1.5 s",
                   "fine_mesh, t = 1.5 s", "particles, t = 2 s", "fine_mesh, t = 2 s"}));
  EXPECT_TRUE(says(animation, "Animation of 3 moments, 0.5 s apart"));
}

TEST(CaseAnimation, KeepsARunThatLacksMomentsAndTellsSoOrThatItHasNone) {
  CaseRuns runs = animated_runs({"particles", "fine_mesh"});
  runs.results.at("fine_mesh").snapshots.pop_back();
  reports::FieldFigure animation = animation_of(animated_case(), runs);
  EXPECT_EQ(animation.columns, 2);
  EXPECT_TRUE(animation.panels.at(5).x.empty());
  EXPECT_TRUE(says(animation, " fine_mesh recorded 2 of these moments."));
  EXPECT_FALSE(says(animation, "particles recorded"));
  runs.results.at("fine_mesh").snapshots.clear();
  animation = animation_of(animated_case(), runs);
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
  EXPECT_TRUE(case_fields({animated_case(), runs, {}, {}, {}}).empty())
      << "one moment is no animation";
}

}  // namespace
}  // namespace slosh::case_fields_test
