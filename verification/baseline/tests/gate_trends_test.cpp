#include "verification/baseline/gate_trends.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "verification/series/time_series.hpp"

namespace slosh::gate_trends_test {
namespace {

GateOutcome outcome(const std::string& mode, double value) {
  GateOutcome result{};
  result.row.candidate = "sph";
  result.row.reference = "linear";
  result.row.quantity = "elevation@right";
  result.row.mode = mode;
  result.row.metric = Metric::amplitude_error;
  result.row.unit = "1";
  result.row.limit = 0.05;
  result.verdict = Verdict::pass;
  result.value = {value, 0.005};
  return result;
}

std::vector<CaseAssessment> campaign(const std::vector<GateOutcome>& rows) {
  CaseAssessment assessment{};
  assessment.definition.name = "surge";
  assessment.gate = rows;
  return {assessment};
}

std::string name_of(const std::string& mode) {
  return "surge: sph against linear, " + mode + " amplitude_error of elevation@right";
}

const BaselineValue first{0.01, 0.005, -0.1, 0.1}, second{0.04, 0.005, -0.05, 0.05};

Approval approval(const std::string& when, const std::optional<BaselineValue>& before,
                  const BaselineValue& after) {
  return {"surges", when, "A", "the start", {{name_of("forced"), before, after}}};
}

CampaignState run_on(const std::string& when, const BaselineValue& value) {
  return {when, {{name_of("forced"), {value, true}}}, {}};
}

std::vector<reports::Trend> trends(const std::vector<Approval>& approvals,
                                   const std::vector<CampaignState>& history,
                                   const std::vector<GateOutcome>& rows) {
  reports::Report report;
  reports::Section section{"surge", "Surge", {}, {}, {}};
  section.tables = {{"surge-runs", "Runs", "", {"run"}, {}},
                    {"surge-gate", "Gate rows", "", {"result"}, {}}};
  report.sections = {section};
  add_gate_trends(approvals, history, campaign(rows), report);
  EXPECT_TRUE(report.sections[0].tables[0].trends.empty());
  return report.sections[0].tables[1].trends;
}

std::vector<double> values_of(const reports::Trend& trend) {
  std::vector<double> values;
  for (const auto& point : trend.points) values.push_back(point.value);
  return values;
}

TEST(GateTrend, HoldsApprovalsAndRunsInTheOrderOfTimeAndEndsWithThePresentValue) {
  const auto made = trends({approval("2026-01-02T00:00:00Z", {}, first),
                            approval("2026-03-02T00:00:00Z", first, second)},
                           {run_on("2026-02-02T00:00:00Z", {0.03, 0.004, -0.1, 0.1})},
                           {outcome("forced", 0.045)});
  ASSERT_EQ(made.size(), 1u);
  EXPECT_EQ(values_of(made[0]), (std::vector{0.01, 0.03, 0.04, 0.045}));
  EXPECT_TRUE(made[0].points[0].is_approved);
  EXPECT_FALSE(made[0].points[1].is_approved);
  EXPECT_EQ(made[0].points[0].upper, 0.1);
  EXPECT_EQ(made[0].points[2].upper, 0.05);
  EXPECT_EQ(made[0].points[1].half_width, 0.004);
}

TEST(GateTrend, ComparesTheValueWithTheOneThatWasApprovedLast) {
  const auto moved = trends({approval("2026-01-02T00:00:00Z", {}, first)},
                            {run_on("2026-02-02T00:00:00Z", second)}, {outcome("forced", 0.04)});
  ASSERT_EQ(moved.size(), 1u);
  EXPECT_TRUE(moved[0].has_changed);
  EXPECT_EQ(moved[0].text.find("approved 2026-01-02: +1 % -> +4 % (4.2 uncertainties)"), 0u)
      << moved[0].text;
  const auto unmoved =
      trends({}, {run_on("2026-02-02T00:00:00Z", second)}, {outcome("forced", 0.041)});
  EXPECT_FALSE(unmoved.at(0).has_changed);
  EXPECT_EQ(unmoved.at(0).text, "run on 2026-02-02: unmoved since");
}

TEST(GateTrend, CountsAnApprovedRunAndThePresentStateOnce) {
  const auto made = trends({approval("2026-01-03T00:00:00Z", {}, second)},
                           {run_on("2026-01-02T00:00:00Z", second),
                            run_on("2026-01-05T00:00:00Z", {0.02, 0.005, -0.05, 0.05})},
                           {outcome("forced", 0.02)});
  EXPECT_EQ(values_of(made.at(0)), (std::vector{0.04, 0.02}));
  EXPECT_TRUE(made[0].points[0].is_approved);
}

TEST(GateTrend, IsNoneWithoutAnEarlierOrAPresentValue) {
  EXPECT_TRUE(trends({}, {}, {outcome("forced", 0.01)}).empty());
  const std::vector<Approval> known = {approval("2026-01-02T00:00:00Z", {}, first)};
  EXPECT_TRUE(trends(known, {}, {outcome("natural_1", 0.01)}).empty());
  const auto made = trends(known, {}, {outcome("forced", not_a_number), outcome("forced", 0.01)});
  ASSERT_EQ(made.size(), 2u);
  EXPECT_TRUE(made[0].points.empty());
  EXPECT_EQ(made[1].points.size(), 2u);
}

TEST(GateTrend, HoldsTheThirtyLatestEarlierValues) {
  std::vector<CampaignState> history;
  for (int i = 10; i < 50; ++i)
    history.push_back(run_on("2026-01-" + std::to_string(i), {0.001 * i, 0.005, -0.05, 0.05}));
  const auto made = trends({}, history, {outcome("forced", 0.01)});
  ASSERT_EQ(made.at(0).points.size(), 31u);
  EXPECT_EQ(made[0].points[0].value, 0.02);
}

}  // namespace
}  // namespace slosh::gate_trends_test
