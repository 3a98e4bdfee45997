// How a candidate stands to its reference, as figures: phasors, sliding fits and convergence, on
// the small surge of surge_results.hpp made wrong by known amounts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reports/drawing/figure_layout.hpp"
#include "verification/tests/figure_results.hpp"

namespace slosh::comparison_figures_test {
namespace {

using Names = std::vector<std::string>;

// Too high by a tenth, and late by the time that is 20 degrees of the forcing.
CaseAssessment high_and_late(CaseDefinition definition = surge_case()) {
  constexpr double forcing = 0.3 * 4.94488;
  const double late = 20 * std::numbers::pi / 180 / forcing;
  TimeSeries series = elevation_of({});
  const TimeSeries sampled = series;
  for (std::size_t i = 0; i < series.time.size(); ++i) {
    const double at = std::max(0.0, (series.time[i] - late) / 0.04);
    const auto before = std::min(static_cast<std::size_t>(at), sampled.value.size() - 2);
    const double part = at - static_cast<double>(before);
    series.value[i] = 1.1 * ((1 - part) * sampled.value[before] + part * sampled.value[before + 1]);
  }
  return assess(definition, surge_runs_with("particles", series));
}

const reports::Curve& curve_of(const reports::Figure& figure, const std::string& label) {
  for (const reports::Curve& curve : figure.curves)
    if (curve.label == label) return curve;
  throw std::out_of_range(label);
}

TEST(PhasorFigure, PutsACandidateThatIsHighAndLateOutsideAndBelowTheLineOfWhatTheGateAllows) {
  const reports::Figure figure = figure_of(high_and_late(), "phasor-forced");
  ASSERT_TRUE(figure.equal_axes);
  const reports::Curve& particles = curve_of(figure, "particles over theory");
  ASSERT_EQ(particles.x.size(), 1u);
  EXPECT_NEAR(std::hypot(particles.x[0], particles.y[0]), 1.1,
              0.02);  // the impulsive start is late too
  EXPECT_NEAR(std::atan2(particles.y[0], particles.x[0]) * 180 / std::numbers::pi, -20, 1);
  EXPECT_GT(particles.x_error.at(0), 0);
  EXPECT_GT(particles.y_error.at(0), 0);
  const reports::Curve& mesh = curve_of(figure, "fine_mesh over theory_with_gas");
  EXPECT_NEAR(mesh.x[0], 1, 1e-9);
  EXPECT_NEAR(mesh.y[0], 0, 1e-9);
  EXPECT_EQ(curve_of(figure, "reference, (1, 0)").x, std::vector<double>{1});
  const reports::Curve sector = curve_of(figure, "tolerance, particles");
  EXPECT_EQ(sector.x.front(), sector.x.back());
  EXPECT_EQ(sector.y.front(), sector.y.back());
  double nearest = 2, farthest = 0, widest = 0;
  for (std::size_t i = 0; i < sector.x.size(); ++i) {
    const double ratio = std::hypot(sector.x[i], sector.y[i]);
    nearest = std::min(nearest, ratio);
    farthest = std::max(farthest, ratio);
    widest = std::max(widest, std::abs(std::atan2(sector.y[i], sector.x[i])));
  }
  EXPECT_NEAR(nearest, 0.95, 1e-12);  // 5 % and 2 deg, of surge_case()
  EXPECT_NEAR(farthest, 1.05, 1e-12);
  EXPECT_NEAR(widest, 2 * std::numbers::pi / 180, 1e-12);
}

TEST(PhasorFigure, LeavesTheLineOpenWhereOneOfAmplitudeAndLagHasNoRow) {
  for (const std::size_t kept : {0u, 1u}) {
    CaseDefinition definition = surge_case();
    definition.gate = {definition.gate.at(kept)};
    const reports::Curve line =
        curve_of(figure_of(high_and_late(definition), "phasor-forced"), "tolerance, particles");
    EXPECT_EQ(std::count_if(line.x.begin(), line.x.end(), [](double x) { return std::isnan(x); }),
              kept == 0 ? 1 : 2);
  }
}

TEST(PhasorFigure, IsOneAModeAndNoneOfAModeThatNobodyResolves) {
  CaseDefinition definition = surge_case();
  definition.natural_modes = 2;
  const auto figures = figures_of(assess(definition, surge_runs()));
  EXPECT_FALSE(figure_of(figures, "phasor-natural_1").id.empty());
  EXPECT_FALSE(figure_of(figures, "phasor-natural_3").id.empty());
  definition.motion = {};
  EXPECT_TRUE(figure_of(assess(definition, surge_runs()), "phasor-forced").id.empty());
}

TEST(SlidingFigures, ShowAConstantErrorAsALevelCurveWithItsTolerance) {
  const auto figures = figures_of(high_and_late());
  const reports::Figure ratio = figure_of(figures, "sliding-amplitude"),
                        lag = figure_of(figures, "sliding-lag");
  const reports::Curve &high = curve_of(ratio, "particles against theory"),
                       &late = curve_of(lag, "particles against theory");
  ASSERT_GE(high.x.size(), 4u);
  for (std::size_t i = 1; i < high.x.size();
       ++i) {  // but for the first, before which there is none
    EXPECT_NEAR(high.y[i], 1.1, 0.05);
    EXPECT_NEAR(late.y[i], 20, 4);
    EXPECT_LT(high.lower[i], high.y[i]);
    EXPECT_GT(late.upper[i], late.y[i]);
  }
  ASSERT_EQ(ratio.bands.size(), 1u);
  EXPECT_NEAR(ratio.bands[0].lower, 0.95, 1e-12);
  ASSERT_EQ(lag.bands.size(), 1u);
  EXPECT_EQ(lag.bands[0].upper, 2);
  EXPECT_GT(reports::plot_ranges(lag).horizontal.lower, 5)
      << "the axis begins where there are data";
}

TEST(SlidingFigures, HaveOneBandForCandidatesThatAreAllowedTheSame) {
  CaseDefinition definition = surge_case();
  for (std::size_t i = 0; i < 2; ++i) {
    definition.gate.push_back(definition.gate[i]);
    definition.gate.back().candidate = "fine_mesh";
    definition.gate.back().reference = "theory_with_gas";
  }
  const CaseAssessment assessment = assess(definition, surge_runs());
  const std::vector<reports::Band> bands = figure_of(assessment, "sliding-lag").bands;
  ASSERT_EQ(bands.size(), 1u);
  EXPECT_EQ(bands[0].label, "tolerance, particles, fine_mesh");
  EXPECT_FALSE(bands[0].look);
}

TEST(ComparisonFigures, LetOneBadModelOfSeveralSetNoScale) {
  for (const double scale : {1.9, 1.05}) {
    const auto figures =
        figures_of(assess_scaled({{"a", SphRun{"recommended", 0.01, 0.01}, 1.02, {}},
                                  {"b", SphRun{"delta_sph", 0.01, 0.01}, 1.03, {}},
                                  {"c", SphRun{"li2010", 0.01, 0.01}, scale, {}}}));
    for (const char* id : {"residual", "sliding-amplitude", "phasor-forced"}) {
      const reports::Figure figure = figure_of(figures, id);
      int seen = 0;
      for (const reports::Curve& curve : figure.curves) {
        if (!curve.label.starts_with("b ") && !curve.label.starts_with("c ")) continue;
        ++seen;
        EXPECT_EQ(curve.sets_scale, curve.label[0] == 'b' || scale < 1.9) << id;
        EXPECT_EQ(figure.caption.find(curve.label) == std::string::npos, curve.sets_scale) << id;
      }
      EXPECT_GE(seen, 2) << id;
    }
  }
}

TEST(SlidingFigures, AreLeftOutWhereTheWindowHoldsTooFewOfThem) {
  CaseDefinition definition = surge_case();
  definition.window_end = 14.5;  // three periods of the forcing are 12.7 s
  EXPECT_TRUE(figure_of(assess(definition, surge_runs()), "sliding-lag").id.empty());
  definition.motion = {};
  definition.natural_modes = 0;
  EXPECT_TRUE(figure_of(assess(definition, surge_runs()), "sliding-lag").id.empty());
}

SphRun at(double spacing) { return {"recommended", spacing, spacing}; }

TEST(ConvergenceFigure, ShowsTheOrderWithGuidesThroughTheCoarsestError) {
  const CaseAssessment assessment = assess_scaled(
      {{"a", at(0.04), 1.16, {}}, {"b", at(0.02), 1.04, {}}, {"c", at(0.01), 1.01, {}}});
  const reports::Figure figure = figure_of(assessment, "convergence-recommended-normalised_rms");
  EXPECT_EQ(labels(figure), (Names{"error, with its 95 % interval", "least squares: order 2",
                                   "order 1", "order 2"}));
  EXPECT_TRUE(figure.log_x && figure.log_y);
  EXPECT_EQ(figure.y_label, "normalised rms [%]");
  const reports::Curve& points = figure.curves.at(0);
  ASSERT_EQ(points.x.size(), 3u);
  EXPECT_NEAR(points.x[0], 40, 1e-9);  // [mm]
  EXPECT_NEAR(points.y[0] / points.y[2], 16, 1e-6);
  const reports::Curve& first = figure.curves.at(2);
  EXPECT_NEAR(first.y.back(), points.y[0], 1e-6);
  EXPECT_NEAR(first.y.back() / first.y.front(), 4, 1e-6);
  EXPECT_TRUE(figure_of(assess_scaled({{"a", at(0.04), 1.16, {}}, {"b", at(0.02), 1.04, {}}}),
                        "convergence-recommended-normalised_rms")
                  .id.empty());
}

TEST(ConvergenceFigure, CutsABandThatIsWiderThanAnyFigure) {
  const CaseAssessment assessment = assess_scaled(
      {{"a", at(0.04), 1.16, {}}, {"b", at(0.02), 1.12, {}}, {"c", at(0.01), 1.01, {}}});
  const reports::Figure figure = figure_of(assessment, "convergence-recommended-normalised_rms");
  const reports::Curve &points = figure.curves.at(0), &line = figure.curves.at(1);
  for (std::size_t i = 0; i < line.y.size(); ++i) {
    EXPECT_LE(line.upper[i], 3 * points.y[0] * (1 + 1e-9));
    EXPECT_GE(line.lower[i], points.y[2] / 3 * (1 - 1e-9));
    EXPECT_LT(line.lower[i], line.y[i]);
  }
}

TEST(ConvergenceFigure, IsOfMeshesOnARefinementPathToo) {
  CaseDefinition definition = surge_case();
  CaseRuns runs = surge_runs();
  definition.refinements = {{"mesh", RefinedNumber::mesh, {}}};
  for (const int cells : {20, 40, 80}) {
    RunDefinition run = sample_run(InterFoamRun{cells, cells, 1});
    run.name = "mesh_" + std::to_string(cells);
    TimeSeries wave = elevation_of({.gas_density = 1.2});
    for (double& value : wave.value) value *= 1 + 2.0 / cells;
    definition.runs.push_back(run);
    definition.refinements[0].runs.push_back(run.name);
    runs.results[run.name] = result_of(run.name, wave);
    runs.status[run.name] = {RunState::finished, ""};
  }
  const reports::Figure figure =
      figure_of(assess(definition, runs), "convergence-mesh-normalised_rms");
  EXPECT_EQ(labels(figure).at(1), "least squares: order 1");
  const TankDefinition tank = definition.tank;
  EXPECT_NEAR(figure.curves.at(0).x.at(0), 1000 * std::sqrt(tank.length * tank.height) / 20, 1e-9);
}

}  // namespace
}  // namespace slosh::comparison_figures_test
