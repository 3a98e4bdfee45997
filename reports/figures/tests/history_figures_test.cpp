// The histories, spectra, motions and energy budgets that a case's section shows: what is drawn of
// which run, and what is left out where the data are missing.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "reports/pages/write_report.hpp"
#include "reports/summary/report_sections.hpp"
#include "verification/tests/figure_results.hpp"
#include "verification/tests/messages.hpp"

namespace slosh::history_figures_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double forcing = 0.3 * 4.94488;  // [rad/s]

using Names = std::vector<std::string>;

TEST(CaseFigures, AreThoseOfTheDataThatAreThere) {
  const CaseAssessment assessment = assess(surge_case(), surge_runs());
  EXPECT_EQ(ids(case_figures(assessment)),
            (Names{"small_surge-history", "small_surge-residual", "small_surge-sliding-amplitude",
                   "small_surge-sliding-lag", "small_surge-phasor-forced",
                   "small_surge-phasor-natural_1", "small_surge-cost", "small_surge-memory"}));
  EXPECT_EQ(ids(appendix_figures(assessment)),
            (Names{"small_surge-spectrum", "small_surge-surge", "small_surge-surge-speed",
                   "small_surge-surge-acceleration"}));
}

TEST(CaseFigures, ShowWhatIsGatedBeforeAllElse) {
  CaseRuns runs = surge_runs();
  add_series(runs, "theory", "force_x", "N/m", 100);
  add_series(runs, "particles", "force_x", "N/m", 100);
  CaseDefinition definition = surge_case();
  for (GateRow& row : definition.gate) row.quantity = "force_x";
  const CaseAssessment assessment = assess(definition, runs);
  EXPECT_EQ(ids(case_figures(assessment)).at(0), "small_surge-force_x");
  EXPECT_EQ(ids(appendix_figures(assessment)).at(0), "small_surge-history");
}

TEST(CaseFigures, HaveUnitsThatSuitALargeTank) {
  CaseRuns runs = surge_runs();
  add_series(runs, "theory", "force_x", "N/m", 2e4);
  CaseDefinition definition = surge_case();
  definition.tank.length = 12;
  definition.tank.height = 2.4;
  definition.liquid.fill_depth = 1.5;
  const CaseAssessment assessment{definition, runs, {}, {}, {}};
  const reports::Figure force = figure_of(assessment, "force_x"),
                        elevation = figure_of(assessment, "history");
  EXPECT_EQ(force.y_label, "force x [kN/m]");
  EXPECT_NEAR(force.curves.at(0).y.at(100), waving("", "", 20).value.at(100), 1e-12);
  EXPECT_EQ(elevation.y_label, "elevation [m]");
  EXPECT_EQ(elevation.curves.at(0).y, elevation_of({}).value);
}

TEST(LoadFigures, ShowWhatARowOnThePeakAllowsOverAllThatItLooksAt) {
  CaseRuns runs = surge_runs();
  add_series(runs, "theory", "force_x", "N/m", 100);
  add_series(runs, "particles", "force_x", "N/m", 100);
  CaseDefinition definition = surge_case();
  definition.window_begin = 5;
  EXPECT_EQ(figure_of({definition, runs, {}, {}, {}}, "force_x").spans.size(), 1u);
  GateRow row = definition.gate[0];
  row.quantity = "force_x";
  row.metric = Metric::largest_magnitude;
  row.mode = "whole";
  row.limit = 300;
  definition.gate = {row};
  const reports::Figure peak = figure_of({definition, runs, {}, {}, {}}, "force_x");
  EXPECT_TRUE(peak.spans.empty()) << "the row looks at the whole run";
  ASSERT_EQ(peak.bands.size(), 1u);
  EXPECT_EQ(peak.bands[0].label, "tolerance, particles");
  EXPECT_EQ(peak.bands[0].upper, 300);
  EXPECT_EQ(peak.bands[0].lower, 0) << "no force pulls";
  definition.gate[0].limit = 3e4;
  EXPECT_TRUE(figure_of({definition, runs, {}, {}, {}}, "force_x").bands.empty());
}

TEST(PressureFigure, ShowsTheoryBothSolversAndTheRecordUnfilteredAndFiltered) {
  CaseDefinition definition = gauged_surge();
  const CaseAssessment assessment = assess(definition, gauged_runs());
  const auto figures = figures_of(assessment);
  const reports::Figure figure = figure_of(figures, "wall_pressure-B"),
                        filtered = figure_of(figures, "filtered_wall_pressure-B");
  for (const reports::Figure& one : {figure, filtered})
    EXPECT_EQ(labels(one), (Names{"theory", "particles", "fine_mesh", "measured"}));
  EXPECT_EQ(figure.y_label, "pressure [Pa]");
  EXPECT_EQ(figure.curves.at(1).y, waving("", "", 1010).value);
  EXPECT_EQ(figure.curves.at(1).x, waving("", "", 1).time);
  EXPECT_EQ(figure.curves.at(3).style, reports::Curve::Style::points);
  EXPECT_EQ(figure.curves[3].y_error, std::vector<double>(1001, 3.0));
  EXPECT_EQ(filtered.curves.at(2).y,
            assessment.runs.results.at("fine_mesh").at("wall_pressure@B/filtered").value);
  EXPECT_NE(filtered.curves[2].y, waving("", "", 1020).value);
  for (const char* told : {"a sensor of 4 mm", "every 0.04 s", "recommended, 10 mm", "50 x 100"})
    EXPECT_TRUE(holds(figure.caption, told)) << told << "\n" << figure.caption;
  EXPECT_TRUE(holds(filtered.caption, "-3 dB at 5 Hz"));
  definition.pressure_gauges[0].filter_cutoff.reset();
  EXPECT_TRUE(figure_of(assess(definition, gauged_runs()), "filtered_wall_pressure-B").id.empty());
}

TEST(PressureFigure, StandsWithValuesThatAreNoNumbersAndWithoutARun) {
  CaseRuns runs = gauged_runs();
  runs.results.at("particles").series.back().value[500] = nan;
  runs.results.erase("measured");
  runs.status["measured"] = {RunState::not_supplied, "expected b.csv"};
  const CaseAssessment assessment = assess(gauged_surge(), runs);
  const CampaignDefinition campaign{"surges", "Surges", "none", "", {}, "", "surges.toml"};
  const reports::Report report = campaign_report(campaign, false, "", {assessment});
  EXPECT_NO_THROW(reports::check_report(report));
  std::vector<reports::Figure> figures;
  for (const reports::Section& section : report.sections)
    figures.insert(figures.end(), section.figures.begin(), section.figures.end());
  EXPECT_EQ(labels(figure_of(figures, "wall_pressure-B")),
            (Names{"theory", "particles", "fine_mesh"}));
  EXPECT_EQ(labels(figure_of(figures, "filtered_wall_pressure-B")), (Names{"theory", "fine_mesh"}));
}

CaseDefinition rolling_case() {
  CaseDefinition definition = surge_case();
  definition.motion.surge.reset();
  definition.motion.roll =
      RollDefinition{SineMotion{4 * std::numbers::pi / 180, forcing}, 0.45, 0.1};
  return definition;
}

TEST(LoadFigures, ShowEachComponentOfThoseThatHaveIt) {
  CaseRuns runs = surge_runs();
  add_series(runs, "theory", "force_x", "N/m", 100);
  add_series(runs, "theory", "moment", "N", 10);
  const struct {
    const char *name, *unit, *label;
    Names shown;
  } loads[] = {{"force_x", "N/m", "force x [N/m]", {"theory", "particles"}},
               {"force_z", "N/m", "force z [N/m]", {"particles"}},
               {"moment", "N", "moment [N]", {"theory", "particles"}},
               {"momentum_x", "kg/s", "momentum x [kg/s]", {"particles"}},
               {"momentum_z", "kg/s", "momentum z [kg/s]", {"particles"}}};
  for (const auto& load : loads) add_series(runs, "particles", load.name, load.unit, 50);
  const auto figures = figures_of({rolling_case(), runs, {}, {}, {}});
  for (const auto& [name, unit, label, shown] : loads) {
    const reports::Figure figure = figure_of(figures, name);
    EXPECT_EQ(labels(figure), shown) << name;
    EXPECT_EQ(figure.y_label, label);
    EXPECT_EQ(figure.curves.back().y, waving("", "", 50).value);
  }
  EXPECT_EQ(figure_of(figures, "force_x").curves.at(0).y, waving("", "", 100).value);
  EXPECT_TRUE(holds(figure_of(figures, "moment").caption, "counter-clockwise"));
}

TEST(HighestSurface, IsShownOverTheDepthAndThePeriodIfThereIsOne) {
  CaseDefinition definition = surge_case();
  CaseRuns runs = surge_runs();
  add_series(runs, "particles", "highest_surface@right", "m", 0.07);
  const auto shown = [&] {
    return figure_of({definition, runs, {}, {}, {}}, "highest_surface-right");
  };
  const reports::Figure moved = shown();
  definition.motion = {};
  const reports::Figure still = shown();
  for (const reports::Figure& one : {moved, still}) ASSERT_EQ(labels(one), (Names{"particles"}));
  EXPECT_EQ(moved.x_label, "time over the forcing period, t/T [1]");
  EXPECT_EQ(moved.y_label, "highest surface, η/h [1]");
  EXPECT_NEAR(moved.curves[0].x.back(), 20 * forcing / (2 * std::numbers::pi), 1e-12);
  EXPECT_NEAR(moved.x_range.second, moved.curves[0].x.back(), 1e-12);
  EXPECT_NEAR(moved.curves[0].y.front(), 0.2, 1e-12);
  EXPECT_EQ(still.x_label, "time [s]");
  EXPECT_EQ(still.y_label, "highest surface [mm]");
  EXPECT_EQ(still.curves[0].x.back(), 20);
  EXPECT_NEAR(still.curves[0].y.front(), 70, 1e-12);
}

TEST(SpectrumFigures, AreOfTheElevationAndOfTheHighestSurface) {
  CaseRuns runs = surge_runs();
  add_series(runs, "particles", "highest_surface@right", "m", 0.07);
  const auto figures = figures_of(assess(surge_case(), runs));
  EXPECT_EQ(labels(figure_of(figures, "spectrum")),
            (Names{"theory", "theory_with_gas", "particles", "fine_mesh"}));
  const reports::Figure highest = figure_of(figures, "spectrum-highest_surface-right");
  ASSERT_EQ(labels(highest), (Names{"particles"}));
  EXPECT_EQ(highest.title, "Spectrum of the highest surface at gauge right");
  EXPECT_EQ(highest.y_label, "power [m2]");
  // A sine of 0.07 m has its peak of 0.07^2 / 2 at the forcing's frequency.
  const reports::Curve& curve = highest.curves[0];
  const auto peak = std::max_element(curve.y.begin(), curve.y.end());
  EXPECT_NEAR(*peak, 0.07 * 0.07 / 2, 0.05 * 0.07 * 0.07);
  EXPECT_NEAR(curve.x[static_cast<std::size_t>(peak - curve.y.begin())],
              forcing / (2 * std::numbers::pi), 1 / (4 * 19.0));
  EXPECT_LE(curve.x.back(), highest.x_range.second);
  CaseRuns still = surge_runs();  // it does not move, or is no number
  add_series(still, "particles", "highest_surface@right", "m", 0);
  add_series(still, "fine_mesh", "highest_surface@right", "m", nan);
  EXPECT_TRUE(figure_of(assess(surge_case(), still), "spectrum-highest_surface-right").id.empty());
}

TEST(SpectrumFigures, MarkTheForcingTwiceItAndTheFirstNaturalMode) {
  CaseDefinition definition = surge_case();
  definition.natural_modes = 0;
  const reports::Figure figure = figure_of(assess(definition, surge_runs()), "spectrum");
  ASSERT_EQ(figure.markers.size(), 3u);
  EXPECT_EQ(figure.markers[0].label, "forced");
  EXPECT_NEAR(figure.markers[0].x, forcing / (2 * std::numbers::pi), 1e-12);
  EXPECT_EQ(figure.markers[1].label, "natural_1");
  EXPECT_NEAR(figure.markers[1].x, 4.96646 / (2 * std::numbers::pi), 1e-6);
  EXPECT_EQ(figure.markers[2].label, "2 x forced");
  EXPECT_NEAR(figure.markers[2].x, forcing / std::numbers::pi, 1e-12);
}

TEST(MotionFigures, ShowTheRollAndTheSurgeOfATankThatRolls) {
  CaseDefinition definition = rolling_case();
  const auto figures = [&] { return figures_of({definition, surge_runs(), {}, {}, {}}); };
  EXPECT_TRUE(figure_of(figures(), "surge").id.empty());
  definition.motion.surge = SineMotion{0.02, forcing};
  const reports::Figure roll = figure_of(figures(), "roll"), surge = figure_of(figures(), "surge");
  ASSERT_EQ(roll.curves.size(), 2u) << "with its peak";
  ASSERT_EQ(roll.curves[0].x.size(), 501u);
  EXPECT_EQ(roll.curves[0].x.back(), 20);
  EXPECT_NEAR(roll.curves[0].y[50], 4 * std::sin(2 * forcing), 1e-9);
  EXPECT_EQ(roll.y_label, "roll [deg]");
  ASSERT_EQ(surge.curves.size(), 2u);
  EXPECT_NEAR(surge.curves[0].y[50], 20 * std::sin(2 * forcing), 1e-9);
  EXPECT_EQ(surge.y_label, "surge [mm]");
}

const Names energies{"kinetic_energy", "potential_energy",  "internal_energy",
                     "wall_work",      "dissipated_energy", "energy_residual"};

TEST(EnergyFigure, ShowsEveryPartOfTheBudgetSinceTheStart) {
  CaseRuns runs = surge_runs();
  for (std::size_t i = 0; i < energies.size(); ++i)
    add_series(runs, "particles", energies[i], "J/m", 1.0 + static_cast<double>(i));
  const reports::Figure figure = figure_of({surge_case(), runs, {}, {}, {}}, "energy-particles");
  EXPECT_EQ(labels(figure), (Names{"kinetic", "potential", "internal", "work of the walls",
                                   "dissipated", "residual"}));
  EXPECT_EQ(figure.y_label, "energy [J/m]");
  for (std::size_t i = 0; i < energies.size(); ++i) {
    EXPECT_EQ(figure.curves[i].y.front(), 0);
    EXPECT_NEAR(figure.curves[i].y[100], (1.0 + static_cast<double>(i)) * std::sin(2 * forcing),
                1e-12);
  }
  runs.results.at("particles").series.pop_back();  // of the budget, a part
  EXPECT_TRUE(figure_of({surge_case(), runs, {}, {}, {}}, "energy-particles").id.empty());
}

TEST(PressureFigure, ShadesTheBandOfARecord) {
  CaseDefinition definition = gauged_surge();
  RecordRun& record = std::get<RecordRun>(definition.runs.back().solver);
  record.uncertainty.reset();
  record.has_band = true;
  CaseRuns runs = gauged_runs();
  for (const auto& [edge, value] : {std::pair{"/lower", 1000.0}, {"/upper", 1100.0}})
    add_series(runs, "measured", std::string("wall_pressure@B") + edge, "Pa", value);
  const CaseAssessment assessment = assess(definition, runs);
  const auto figures = figures_of(assessment);
  const reports::Curve measured = figure_of(figures, "wall_pressure-B").curves.at(3);
  EXPECT_EQ(measured.lower, waving("", "", 1000).value);
  EXPECT_EQ(measured.upper, waving("", "", 1100).value);
  EXPECT_EQ(measured.ribbon, "band of the experiment's repeats");
  EXPECT_EQ(measured.style, reports::Curve::Style::line);
  EXPECT_EQ(figure_of(figures, "filtered_wall_pressure-B").curves.at(3).lower,
            assessment.runs.results.at("measured").at("wall_pressure@B/filtered/lower").value);
}

}  // namespace
}  // namespace slosh::history_figures_test
