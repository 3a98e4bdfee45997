#include "verification/evidence/history_uncertainty.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "reports/figures/case_figures.hpp"
#include "verification/case/quantities.hpp"
#include "verification/evidence/run_cost.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/tests/figure_results.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/sample_case.hpp"

namespace slosh::history_uncertainty_test {
namespace {

// "particles" at 10 mm, besides runs at other spacings, each too high by error(h).
struct Spacings {
  CaseDefinition definition = surge_case();
  CaseRuns runs = surge_runs();

  template <class Error>
  Spacings(const std::vector<double>& coarser_spacings, Error error) {
    definition.refinements = {{"spacing", RefinedNumber::particle_spacing, {"particles"}}};
    runs.results["particles"] = result_of("particles", scaled(elevation_of({}), 1 + error(0.01)));
    for (const double spacing : coarser_spacings) {
      RunDefinition coarse = definition.runs.at(2);
      coarse.name = "particles_" + std::to_string(std::lround(1000 * spacing));
      auto& sph = std::get<SphRun>(coarse.solver);
      sph.particle_spacing = sph.surface_particle_spacing = spacing;
      definition.runs.push_back(coarse);
      definition.refinements[0].runs.push_back(coarse.name);
      runs.results[coarse.name] =
          result_of(coarse.name, scaled(elevation_of({}), 1 + error(spacing)));
      runs.status[coarse.name] = {RunState::finished, ""};
    }
  }
  std::vector<double> widths(const std::string& run = "particles") const {
    return numerical_half_widths(definition, runs, run, surge_quantity);
  }
};

double second_order(double spacing) { return 100 * spacing * spacing; }

TEST(HistoryUncertainty, OfThreeRunsIsTheErrorThatTheirOrderLeavesTimesItsSafetyFactor) {
  const std::vector<double> widths = Spacings({0.02, 0.04}, second_order).widths();
  const TimeSeries wave = elevation_of({});
  ASSERT_EQ(widths.size(), wave.value.size());
  for (std::size_t i = 0; i < widths.size(); i += 50)
    EXPECT_NEAR(widths[i], 1.25 * second_order(0.01) * std::abs(wave.value[i]), 1e-9) << i;
}

TEST(HistoryUncertainty, OfAnOrderThatNothingExplainsHasTheCautiousFactor) {
  const auto fourth_order = [](double h) { return 1e5 * h * h * h * h; };
  const std::vector<double> widths = Spacings({0.02, 0.04}, fourth_order).widths();
  const TimeSeries wave = elevation_of({});
  const double apart = fourth_order(0.02) - fourth_order(0.01);
  EXPECT_NEAR(widths[250], 3 * apart / (2 * 2 - 1) * std::abs(wave.value[250]), 1e-9);
}

TEST(HistoryUncertainty, OfTwoRunsIsThreeTimesTheirDifferenceOnAnErrorOfFirstOrder) {
  const std::vector<double> widths = Spacings({0.015}, second_order).widths();
  const double apart = second_order(0.015) - second_order(0.01);
  EXPECT_NEAR(widths[250], 3 * apart / 0.5 * std::abs(elevation_of({}).value[250]), 1e-9);
}

TEST(HistoryUncertainty, IsNoneWithoutACoarserRunThatCanBeRead) {
  EXPECT_TRUE(Spacings({}, second_order).widths().empty());
  Spacings spacings({0.02}, second_order);
  EXPECT_TRUE(spacings.widths("particles_20").empty());
  EXPECT_TRUE(spacings.widths("theory").empty());
  spacings.runs.results.at("particles_20").series[0].value[300] = std::nan("");
  EXPECT_TRUE(spacings.widths().empty());
}

TEST(HistoryUncertainty, IsNoneOfACopyThatWasTouched) {
  EXPECT_TRUE(Spacings({0.02}, [](double h) { return 1e-7 * h; }).widths().empty());
}

TEST(HistoryUncertainty, OfPotentialFlowIsWhatItsCoarserRunDiffersBy) {
  Spacings spacings({}, second_order);
  TimeSeries coarse = scaled(elevation_of({}), 1.03);
  coarse.name += coarser;
  spacings.runs.results.at("theory").series.push_back(coarse);
  EXPECT_NEAR(spacings.widths("theory").at(250), 0.03 * std::abs(elevation_of({}).value[250]),
              1e-12);
}

// Potential flow ends where it leaves its range, and that of fewer nodes may do so earlier.
TEST(HistoryUncertainty, OfPotentialFlowEndsWithTheShorterOfItsTwoRuns) {
  Spacings spacings({}, second_order);
  TimeSeries coarse = scaled(elevation_of({}), 1.03);
  coarse.name += coarser;
  coarse.time.resize(17);
  coarse.value.resize(17);
  spacings.runs.results.at("theory").series.push_back(coarse);
  const std::vector<double> widths = spacings.widths("theory");
  ASSERT_EQ(widths.size(), 501u);
  EXPECT_NEAR(widths[16], 0.03 * std::abs(elevation_of({}).value[16]), 1e-12);
  for (std::size_t i = 17; i < widths.size(); ++i) EXPECT_TRUE(std::isnan(widths[i])) << i;
  const reports::Figure figure = figure_of(assess(spacings.definition, spacings.runs), "history");
  for (const double edge : figure.curves.at(0).upper)
    EXPECT_FALSE(std::abs(edge) > 1000) << "[mm], of a wave of some 10 mm";
}

TEST(MainHistory, HasARibbonAboutTheRunThatHasCoarserOnesAndShadesWhatIsNotCompared) {
  const Spacings spacings({0.02, 0.04}, second_order);
  const reports::Figure figure = figure_of(assess(spacings.definition, spacings.runs), "history");
  ASSERT_EQ(figure.curves.at(2).label, "particles");
  const reports::Curve& curve = figure.curves[2];
  ASSERT_EQ(curve.lower.size(), curve.y.size());
  const double half = 1000 * spacings.widths()[250];  // [mm]
  EXPECT_NEAR(curve.upper[250] - curve.y[250], half, 1e-9);
  EXPECT_NEAR(curve.y[250] - curve.lower[250], half, 1e-9);
  EXPECT_TRUE(figure.curves.at(0).lower.empty());
  EXPECT_TRUE(holds(figure.caption, "Ribbons around solvers"));
  ASSERT_EQ(figure.spans.size(), 1u);  // the window ends with the case
  EXPECT_EQ(figure.spans[0].begin, 0);
  EXPECT_EQ(figure.spans[0].end, 1);
}

TEST(ResidualFigure, HasTheAxisOfWhatIsCompared) {
  CaseDefinition definition = surge_case();
  definition.window_end = 19;
  const CaseAssessment assessment = assess(definition, surge_runs());
  const reports::Figure figure = figure_of(assessment, "residual");
  EXPECT_EQ(figure.x_range, (std::pair{1.0, 19.0}));
  EXPECT_TRUE(figure.spans.empty());
}

TEST(LeftOutAsCompiling, IsToldOfTheRunWithTheLargestShareAndDoubtfulAboveOneHalf) {
  CaseDefinition definition = sample_case();
  CaseRuns runs;
  const auto add = [&](const char* name, double spacing, double took) {
    ExternalRun external;
    external.command = {"./solve"};
    external.method = "mine";
    external.particle_spacing = spacing;
    RunDefinition run{};
    run.name = name;
    run.solver = external;
    definition.runs.push_back(run);
    runs.results[name].cost.user_time = took;
  };
  add("coarse", 0.04, 1.5);
  add("fine", 0.02, 6);
  GateRow row{};
  row.candidate = "fine";
  EXPECT_EQ(left_out_as_compiling(definition, runs, row).text, "") << "no program says so";
  runs.results["coarse"].diagnostics["compile_processor_time_s"] = 0;
  EXPECT_EQ(left_out_as_compiling(definition, runs, row).text, "");
  runs.results["coarse"].diagnostics["compile_processor_time_s"] = 0.5;
  runs.results["fine"].diagnostics["compile_processor_time_s"] = 0.6;
  EXPECT_EQ(left_out_as_compiling(definition, runs, row).text,
            "; coarse says itself that 0.5 s were compiling, 25 % of what it took; they do not "
            "count");
  runs.results["fine"].diagnostics["compile_processor_time_s"] = 9;
  EXPECT_EQ(left_out_as_compiling(definition, runs, row).text,
            "; doubtful: fine says itself that 9 s were compiling, 60 % of what it took; they do "
            "not count");
}

// A program that keeps its result beside it is fast when it is timed.
TEST(LeftOutAsCompiling, DoubtsACostThatTheRunItselfExceeds) {
  CaseDefinition definition = sample_case();
  RunDefinition run{};
  run.name = "fine";
  run.solver = ExternalRun{.command = {"./solve"}, .method = "mine", .particle_spacing = 0.02};
  definition.runs.push_back(run);
  GateRow row{};
  row.candidate = "fine";
  for (const auto& [first, is_doubted] :
       {std::pair{0.8, true}, {0.12, false}, {0.06, false}, {0.01, false}}) {
    CaseRuns runs;
    runs.results["fine"].cost.user_time = first;
    for (const double again : {0.058, 0.06}) {
      RunCost cost{};
      cost.user_time = again;
      runs.timings["fine"].push_back(cost);
    }
    const RowDoubts told = left_out_as_compiling(definition, runs, row);
    EXPECT_EQ(told.is_doubtful, is_doubted) << first;
    EXPECT_EQ(told.text.find("doubtful") != std::string::npos, is_doubted) << first;
  }
}

}  // namespace
}  // namespace slosh::history_uncertainty_test
