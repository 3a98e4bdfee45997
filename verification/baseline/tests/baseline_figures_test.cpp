#include "verification/baseline/baseline_figures.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slosh::baseline_figures_test {
namespace {

using Names = std::vector<std::string>;

GateOutcome outcome(const std::string& mode, double value, double limit = 0.05) {
  GateOutcome result{};
  result.row.candidate = "sph";
  result.row.reference = "linear";
  result.row.quantity = "elevation@right";
  result.row.mode = mode;
  result.row.metric = Metric::amplitude_error;
  result.row.unit = "1";
  result.row.limit = limit;
  result.verdict = Verdict::pass;
  result.value = {value, 0.005};
  return result;
}

std::string name_of(const std::string& mode) {
  return "sph against linear, " + mode + " amplitude_error of elevation@right";
}

std::vector<CaseAssessment> campaign(const std::vector<GateOutcome>& rows) {
  CaseAssessment assessment{};
  assessment.definition.name = "surge";
  assessment.gate = rows;
  return {assessment};
}

BaselineChange change(const std::string& mode, std::optional<BaselineValue> before,
                      std::optional<BaselineValue> after) {
  return {"surge: " + name_of(mode), before, after};
}

const BaselineValue first{0.01, 0.005, -0.1, 0.1}, second{0.02, 0.005, -0.05, 0.05};

std::vector<Approval> two_approvals() {
  return {
      {"surges", "2026-01-02T03:04:05Z", "A", "the start", {change("forced", {}, first)}},
      {"surges", "2026-02-03T03:04:05Z", "B", "a better wall", {change("forced", first, second)}}};
}

std::vector<reports::Figure> figures(const std::vector<Approval>& approvals,
                                     const std::vector<GateOutcome>& rows) {
  reports::Report report;
  report.sections = {{"gate", "Gate", {}, {}, {}}, {"surge", "Surge", {}, {}, {}}};
  add_baseline_figures(approvals, campaign(rows), report);
  EXPECT_TRUE(report.sections[0].figures.empty());
  return report.sections[1].figures;
}

TEST(BaselineFigure, PutsEachValueIntoTheToleranceOfItsTime) {
  const auto made = figures(two_approvals(), {outcome("forced", -0.04)});
  ASSERT_EQ(made.size(), 1u);
  const reports::Figure& figure = made[0];
  EXPECT_EQ(figure.id, "surge-baselines");
  ASSERT_EQ(figure.curves.size(), 1u);
  EXPECT_EQ(figure.curves[0].label, name_of("forced"));
  EXPECT_EQ(figure.curves[0].x, (std::vector<double>{1, 2, 3}));
  ASSERT_EQ(figure.curves[0].y.size(), 3u);
  EXPECT_NEAR(figure.curves[0].y[0], 0.1, 1e-12);
  EXPECT_NEAR(figure.curves[0].y[1], 0.4, 1e-12);
  EXPECT_NEAR(figure.curves[0].y[2], -0.8, 1e-12);
  EXPECT_NEAR(figure.curves[0].y_error[0], 0.05, 1e-12);
  EXPECT_NEAR(figure.curves[0].y_error[2], 0.1, 1e-12);
  EXPECT_EQ(figure.x_ticks, (std::vector<std::pair<double, std::string>>{
                                {1, "1: 2026-01-02"}, {2, "2: 2026-02-03"}, {3, "now"}}));
  EXPECT_EQ(figure.bands.at(0).upper, 1);
  EXPECT_NE(figure.caption.find("2: B, a better wall."), std::string::npos);
}

TEST(BaselineFigure, ShowsTheRowsThatAreFurthestOutFirstAndSixAtMost) {
  std::vector<GateOutcome> rows;
  for (int i = 1; i <= 7; ++i) rows.push_back(outcome("natural_" + std::to_string(i), 0.001 * i));
  rows.push_back(outcome("forced", -0.06));
  const auto made = figures(two_approvals(), rows);
  ASSERT_EQ(made.size(), 1u);
  ASSERT_EQ(made[0].curves.size(), 6u);
  EXPECT_EQ(made[0].curves[0].label, name_of("forced"));
  EXPECT_EQ(made[0].curves[1].label, name_of("natural_7"));
  EXPECT_TRUE(std::isnan(made[0].curves[1].y[0]));  // no baseline of it
  EXPECT_NEAR(made[0].curves[1].y[2], 0.14, 1e-12);
}

TEST(BaselineFigure, IsNoneWithoutAnApprovalOrABaselineOfTheCase) {
  EXPECT_TRUE(figures({}, {outcome("forced", 0.01)}).empty());
  EXPECT_TRUE(figures(two_approvals(), {outcome("natural_1", 0.01)}).empty());
  GateOutcome without_tolerance = outcome("forced", 0.01);
  without_tolerance.row.limit.reset();
  without_tolerance.row.improves_on = "other";
  EXPECT_TRUE(figures(two_approvals(), {without_tolerance}).empty());
}

TEST(BaselineFigure, ShowsTheLatestTwelveApprovalsAndSixOfTheirDates) {
  std::vector<Approval> approvals = two_approvals();
  for (int i = 0; i < 18; ++i)
    approvals.push_back({"surges", "2026-03-04T00:00:00Z", "C", "again", {}});
  const auto made = figures(approvals, {outcome("forced", 0.01)});
  ASSERT_EQ(made.size(), 1u);
  EXPECT_EQ(made[0].curves[0].x.front(), 9);
  EXPECT_EQ(made[0].curves[0].x.back(), 21);
  EXPECT_EQ(made[0].x_ticks.size(), 7u);
}

}  // namespace
}  // namespace slosh::baseline_figures_test
