// Panels of solvers over the runs of a case: what is measured of each member, which solver is
// apart, and what is told of members and solvers that are missing.
#include "verification/assessment/across_runs/panels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "verification/assessment/across_runs/panel_values.hpp"
#include "verification/series/windowed_series.hpp"
#include "verification/tests/panel_runs.hpp"

namespace slosh::panels_test {
namespace {

const PanelRow& row_of(const std::vector<PanelAssessment>& panels, const std::string& mode,
                       PanelMetric metric) {
  for (const PanelAssessment& panel : panels)
    for (const PanelRow& row : panel.rows)
      if (row.mode == mode && row.metric == metric) return row;
  throw std::logic_error("no such row");
}

TEST(Panels, MeasureEachMemberByItself) {
  const auto panels = panels_of(panel_runs());
  ASSERT_EQ(panels.size(), 2U);
  EXPECT_EQ(panels[0].rows.size(), 4U * 3U + 1U);
  const PanelRow& peak = row_of(panels, "impact_2", PanelMetric::impact_peak);
  EXPECT_EQ(peak.unit, "Pa");
  ASSERT_EQ(peak.solvers.size(), 4U);
  EXPECT_EQ(peak.solvers[0].values.size(), 8U);
  EXPECT_NEAR(peak.solvers[1].mean->mean, 4816, 1);
  EXPECT_NEAR(peak.solvers[1].mean->deviation, 4816 * 0.03 * std::sqrt(2.5 / 4), 1);
  EXPECT_NEAR(row_of(panels, "impact_3", PanelMetric::impact_arrival).solvers[1].mean->mean, 5.715,
              0.002);
  EXPECT_NEAR(row_of(panels, "impact_3", PanelMetric::impulse).solvers[1].mean->mean,
              0.0459 * 670 + (4691 - 670) * std::sqrt(8e-6 * std::numbers::pi), 0.7);
  EXPECT_NEAR(row_of(panels, "whole", PanelMetric::plateau).solvers[1].mean->mean, 670, 1);
}

TEST(Panels, NameTheSolverThatIsApart) {
  const auto panels = panels_of(panel_runs());
  for (const char* mode : {"impact_1", "impact_4"}) {
    const PanelRow& row = row_of(panels, mode, PanelMetric::impact_peak);
    ASSERT_TRUE(row.odd());
    EXPECT_EQ(row.odd()->run, "particles");
    EXPECT_EQ(panel_finding(row), "one apart");
  }
  EXPECT_EQ(row_of(panels, "whole", PanelMetric::rms).odd()->run, "particles");
  EXPECT_EQ(panel_finding(row_of(panels, "whole", PanelMetric::lag)), "all agree");
}

TEST(Panels, TellWhatTheAirsCompressibilityChanges) {
  const auto panels = panels_of(panel_runs());
  const PanelRow& peak = row_of(panels, "impact_1", PanelMetric::impact_peak);
  ASSERT_TRUE(peak.air_share);
  EXPECT_NEAR(peak.air_share->value, 0.02, 0.001);
  EXPECT_NEAR(peak.air_share->half_width, 0.045, 0.015);
  // Of a time it is the difference.
  EXPECT_NEAR(row_of(panels, "impact_1", PanelMetric::impact_arrival).air_share->value, 0, 1e-3);
  EXPECT_FALSE(row_of(panels, "whole", PanelMetric::rms).air_share) << "none is asked";
}

TEST(Panels, CountAnImpactThatNeverCame) {
  CaseAssessment assessment = panel_runs();
  assessment.runs.results.at("cells_2") = result_with("cells_2", {pressure_of({.impacts = 2})});
  const auto panels = panels_of(assessment);
  const PanelSolver& cells = row_of(panels, "impact_3", PanelMetric::impact_peak).solvers[1];
  EXPECT_EQ(cells.without_value, 1U);
  EXPECT_EQ(cells.values.size(), 4U);
  EXPECT_TRUE(cells.mean);
  EXPECT_EQ(row_of(panels, "impact_2", PanelMetric::impact_peak).solvers[1].without_value, 0U);
}

TEST(Panels, TellWhyAMemberIsLeftOut) {
  CaseAssessment assessment = panel_runs();
  assessment.runs.results.erase("sharp_3");
  assessment.runs.status["sharp_3"] = {RunState::failed, "it diverged"};
  TimeSeries poisoned = pressure_of({});
  for (double& value : poisoned.value) value = not_a_number;
  assessment.runs.results.at("particles_2") = result_with("particles_2", {poisoned});
  assessment.runs.results.at("particles_3") = result_with("particles_3", {});
  const auto panels = panels_of(assessment);
  for (const auto& [mode, metric] : {std::pair{"impact_1", PanelMetric::impact_peak},
                                     {"whole", PanelMetric::rms},
                                     {"whole", PanelMetric::lag}}) {
    const PanelRow& row = row_of(panels, mode, metric);
    ASSERT_EQ(row.solvers[2].left_out.size(), 1U);
    EXPECT_EQ(row.solvers[2].left_out[0], "sharp_3 (solver failed)");
    EXPECT_TRUE(row.solvers[2].mean);
    EXPECT_EQ(row.solvers[0].values.size(), 6U);
    EXPECT_EQ(row.solvers[0].left_out.size(), 2U);
  }
}

TEST(Panels, LeaveOutASolverOfFewerThanThreeMembers) {
  CaseAssessment assessment = panel_runs();
  for (const char* run : {"air", "air_2"}) {
    assessment.runs.results.erase(run);
    assessment.runs.status[run] = {RunState::not_selected, ""};
  }
  const auto panels = panels_of(assessment);
  const PanelRow& row = row_of(panels, "impact_1", PanelMetric::impact_peak);
  EXPECT_FALSE(row.solvers[3].mean);
  EXPECT_EQ(row.solvers[3].left_out.at(0), "air (not selected)");
  EXPECT_EQ(row.judged, (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(row.odd()->run, "particles");
  EXPECT_FALSE(row.air_share);
}

TEST(Panels, OfOneSolverAloneFindNothing) {
  CaseAssessment assessment = panel_runs();
  for (auto& [run, status] : assessment.runs.status)
    if (!run.starts_with("cells")) {
      assessment.runs.results.erase(run);
      status = {RunState::not_selected, ""};
    }
  for (const PanelAssessment& panel : panels_of(assessment))
    for (const PanelRow& row : panel.rows) {
      EXPECT_FALSE(row.verdict);
      EXPECT_EQ(panel_finding(row), "too few solvers");
    }
}

TimeSeries wave(double late) {
  TimeSeries series{impact_pressure, "Pa", {}, {}};
  for (int i = 0; i <= 800; ++i) {
    series.time.push_back(0.01 * i);
    series.value.push_back(std::sin(3.85 * (series.time.back() - late)));
  }
  return series;
}

TEST(PanelValues, OfTheMeanHistoryCountEachSolverOnce) {
  const TimeSeries history = mean_history({{wave(0), wave(0), wave(0)}, {wave(0.1)}, {}});
  const double middle = 0.5 * (wave(0).value[400] + wave(0.1).value[400]);
  EXPECT_NEAR(history.value[400], middle, 1e-9);
  EXPECT_THROW(mean_history({{}, {}}), ComparisonError);
}

TEST(PanelValues, MeasureTheLagBehindTheMeanHistory) {
  const CaseDefinition definition = panel_runs().definition;
  const TimeSeries history = cut_to_window(wave(0.1), {1, 8});
  const PanelQuestion question{definition, definition.panels[1], PanelMetric::lag, "whole",
                               &history};
  EXPECT_NEAR(panel_value(question, wave(0.13)), 0.03, 2e-3);
  EXPECT_NEAR(panel_value(question, wave(0.05)), -0.05, 2e-3);
  EXPECT_THROW(panel_value({definition, definition.panels[1], PanelMetric::lag, "whole"}, wave(0)),
               ComparisonError);
}

}  // namespace
}  // namespace slosh::panels_test
