// The comparison of wall treatments on results made by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "reports/pages/write_report.hpp"
#include "verification/papers/paper_sections.hpp"
#include "verification/tests/impact_runs.hpp"

namespace slosh::wall_treatments_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <class Function>
TimeSeries series_of(const std::string& name, const std::string& unit, const Function& f) {
  TimeSeries series{name, unit, {}, {}};
  for (int i = 0; i <= 2000; ++i) {
    series.time.push_back(0.005 * i);
    series.value.push_back(f(0.005 * i));
  }
  return series;
}

// A run whose pressure has a noise of this amplitude [Pa], whose gap is 0.1 and whose volume drifts
// by 1 % over the 10 s.
std::vector<TimeSeries> still(double noise) {
  return {
      series_of("wall_pressure@B", "Pa",
                [=](double t) { return 1000 + noise * std::sin(2 * std::numbers::pi * 30 * t); }),
      series_of("wall_gap", "1", [](double t) { return t < 8 - 1e-9 ? 5 : 0.1; }),
      series_of("volume_drift", "1", [](double t) { return 0.001 * t; })};
}

CaseAssessment tagged_case(const std::string& tag = "walls") {
  CaseDefinition definition = sample_case();
  definition.name = "still_tank";
  definition.tags = {tag};
  definition.duration = 10;
  definition.window_end = 10;
  definition.pressure_gauges = {{.name = "B", .wall = Wall::left, .position = 0.1}};
  CaseAssessment assessment = no_runs_of(definition);
  for (const auto& [name, noise] : {std::pair{"mirror", 1.0}, {"dynamic_fixed", 10.0}}) {
    add_run(assessment, name, SphRun{"any", 0.01, 0.01}, still(noise));
    RunResult& result = assessment.runs.results[name];
    result.diagnostics["wall_crossings"] = 0;
    result.cost = {.user_time = 3, .steps = 1000, .elements = 2000};
  }
  return assessment;
}

TEST(WallTreatments, AreLeftOutWithoutTheTagOrARunOfTheirNames) {
  EXPECT_FALSE(wall_treatment_section({}));
  EXPECT_FALSE(wall_treatment_section({tagged_case("surge")}));
  CaseAssessment others = tagged_case();
  for (RunDefinition& run : others.definition.runs) run.name += "_too";
  EXPECT_FALSE(wall_treatment_section({others}));
}

TEST(WallTreatments, AreMeasuredOverTheLastFifthAndPerParticleAndStep) {
  const auto section = wall_treatment_section({tagged_case()});
  ASSERT_TRUE(section);
  const auto& rows = section->tables.at(0).rows;
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].at(1), "dynamic_fixed");
  EXPECT_EQ(rows[1], (std::vector<std::string>{"still_tank", "mirror", "+0.100", rows[1].at(3),
                                               "+0.900", "0", "confirmed", "1500", ""}));
  EXPECT_NEAR(std::stod(rows[1][3]) / (0.5 / (1e6 + 0.5)), 1, 0.02);
  EXPECT_NEAR(std::stod(rows[0][3]) / std::stod(rows[1][3]), 100, 2);
  reports::Report report;
  report.results_json = "{}";
  report.sections = {*section};
  EXPECT_NO_THROW(reports::check_report(report));
}

TEST(WallTreatments, HoldTheLiquidOnlyWhereNothingCrossedAWallAndSayWhatIsNaNOrHasNoResult) {
  CaseAssessment assessment = tagged_case();
  const auto verdict = [&](std::optional<double> crossings) {
    auto& diagnostics = assessment.runs.results["mirror"].diagnostics;
    diagnostics.clear();
    if (crossings) diagnostics["wall_crossings"] = *crossings;
    return wall_treatment_section({assessment})->tables[0].rows.at(1).at(6);
  };
  EXPECT_EQ(verdict(0), "confirmed");
  EXPECT_EQ(verdict(1), "refuted");
  EXPECT_EQ(verdict(nan), "not decidable");
  EXPECT_EQ(verdict({}), "not decidable");
  for (TimeSeries& series : assessment.runs.results["mirror"].series) series.value[1900] = nan;
  add_absent_run(assessment, "repulsive_mirror", SphRun{"li2010", 0.01, 0.01}, RunState::failed);
  const auto rows = wall_treatment_section({assessment})->tables[0].rows;
  EXPECT_EQ(rows.at(0),
            (std::vector<std::string>{"still_tank", "repulsive_mirror", "", "", "", "",
                                      "not decidable", "", "solver failed: so it goes"}));
  for (const std::size_t column : {2u, 3u, 4u}) EXPECT_EQ(rows.at(2).at(column), "not available");
  EXPECT_EQ(wall_treatment_section({assessment})->figures.at(0).curves.size(), 1u);
}

TEST(WallTreatments, AreDrawnByNoiseAndCostWithACurveForEach) {
  CaseAssessment second = tagged_case();
  second.definition.name = "standing_wave";
  const auto section = wall_treatment_section({tagged_case(), second});
  ASSERT_EQ(section->figures.size(), 1u);
  const auto& curves = section->figures[0].curves;
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_EQ(curves[0].label, "dynamic_fixed");
  EXPECT_EQ(curves[0].x, (std::vector<double>{1500, 1500}));
  EXPECT_EQ(curves[0].y.size(), 2u);
  EXPECT_EQ(section->tables[0].rows.size(), 4u);
}

}  // namespace
}  // namespace slosh::wall_treatments_test
