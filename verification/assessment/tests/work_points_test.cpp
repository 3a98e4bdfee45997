// Costs and errors of runs by family, and what a gate row, the report and results.json make of
// them.
#include "verification/assessment/work_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <tuple>

#include "reports/figures/case_figures.hpp"
#include "reports/summary/report_sections.hpp"
#include "reports/summary/results_json.hpp"
#include "reports/tables/case_tables.hpp"
#include "verification/assessment/across_runs/speed_ups.hpp"
#include "verification/sensitivity/gate_sensitivity.hpp"
#include "verification/tests/figure_results.hpp"

namespace slosh::work_points_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double mebibyte = 1048576;

RunCost cost(double core_seconds, double memory = 16 * mebibyte) {
  return {.wall_time = core_seconds,
          .user_time = 0.75 * core_seconds,
          .system_time = 0.25 * core_seconds,
          .peak_memory = memory};
}

// Three runs of one family, errors 20, 10 and 5 %, times 1, 8 and 64 s; and one that changes
// something.
const CaseAssessment& three_resolutions() {
  SphRun coarse{"recommended", 0.02, 0.02}, medium{"recommended", 0.01, 0.01},
      fine{"recommended", 0.005, 0.005}, changed = medium;
  changed.variant = "antuono";
  static const CaseAssessment assessment =
      assess_scaled({{"fine", fine, 1.05, cost(64, 64 * mebibyte)},
                     {"coarse", coarse, 1.2, cost(1)},
                     {"medium", medium, 1.1, cost(8, 32 * mebibyte)},
                     {"changed", changed, 1.3, cost(30)}});
  return assessment;
}

// The same of an external program's method, and a run of a program that names none.
const CaseAssessment& three_resolutions_of_a_program() {
  const auto mine = [](double spacing) {
    return ExternalRun{{"my_sph"}, {}, {}, {}, {}, "my_sph", spacing};
  };
  static const CaseAssessment assessment =
      assess_scaled({{"fine", mine(0.005), 1.05, cost(64)},
                     {"coarse", mine(0.02), 1.2, cost(1)},
                     {"medium", mine(0.01), 1.1, cost(8)},
                     {"other", ExternalRun{{"other"}}, 1.3, cost(30)}});
  return assessment;
}

using Timings = std::map<std::string, std::vector<RunCost>>;

// Each of the three runs five times; a standard deviation of 2 % of its cost.
Timings five_timings(double scale = 1) {
  Timings timings;
  for (const auto& [run, seconds] : {std::pair{"coarse", 1.0}, {"medium", 8.0}, {"fine", 64.0}})
    for (const double share : {0.9747, 0.9874, 1.0, 1.0126, 1.0253})
      timings[run].push_back(cost(scale * seconds * share));
  return timings;
}

GateRow cost_row(double error, double limit) {
  GateRow row = surge_row("whole", Metric::cost_to_reach, "s", limit);
  row.candidate = "medium";
  row.error = error;
  return row;
}

CaseAssessment judged(const std::vector<GateRow>& rows, const Timings& timings,
                      const CaseAssessment& one = three_resolutions()) {
  CaseDefinition definition = one.definition;
  definition.gate = rows;
  CaseRuns runs = one.runs;
  runs.timings = timings;
  return assess(definition, runs);
}

GateOutcome judge(const GateRow& row, const Timings& timings) {
  return judged({row}, timings).gate.at(0);
}

// The three schemes' runs alone, beside which a mesh may stand.
const std::vector<ScaledRun> three_particles{
    {"coarse", SphRun{"recommended", 0.02, 0.02}, 1.2, cost(1)},
    {"medium", SphRun{"recommended", 0.01, 0.01}, 1.1, cost(8)},
    {"fine", SphRun{"recommended", 0.005, 0.005}, 1.05, cost(64)}};

const reports::Table& table_named(const std::vector<reports::Table>& tables,
                                  const std::string& id) {
  for (const reports::Table& table : tables)
    if (table.id == "small_surge-" + id) return table;
  throw std::logic_error("no table " + id);
}

// The runs of three_resolutions_of_a_program() take as much processor time as wall time.
TEST(ExternalCosts, AreMarkedWhereTheyAreThoseOfMoreCores) {
  CaseAssessment assessment = three_resolutions_of_a_program();
  CaseRuns runs = assessment.runs;
  for (RunDefinition& run : assessment.definition.runs)
    if (auto* external = std::get_if<ExternalRun>(&run.solver)) external->cores = 2;
  runs.results.at("fine").cost.user_time = 130;
  runs.results.at("medium").cost.user_time = 16;
  const CaseAssessment marked = assess(assessment.definition, runs);
  EXPECT_EQ(marked.runs.status.at("fine").message,
            "146 core-seconds in 64 s: more than its cores = 2 have");
  EXPECT_EQ(marked.runs.status.at("medium").message,
            "18 core-seconds in 8 s: more than its cores = "
            "2 have");
  EXPECT_EQ(marked.runs.status.at("coarse").message, "");
}

// Beside the runs of this machine.
CaseAssessment with_a_stored_result() {
  CaseAssessment assessment =
      assess_scaled({{"coarse", SphRun{"recommended", 0.02, 0.02}, 1.2, cost(1)},
                     {"theirs", SphRun{"li2010", 0.02, 0.02}, 1.1, cost(64)}});
  for (RunDefinition& run : assessment.definition.runs)
    if (run.name == "theirs") run.solver = StoredRun{{}, "their_sph", 0.02, "cost.json"};
  assessment.runs.results.at("theirs").provenance = {{"stored_software", "their SPH 5.4"},
                                                     {"stored_date", "2026-11-22"},
                                                     {"stored_machine", "one core"},
                                                     {"stored_remark", "Built by themselves."},
                                                     {"slosh_version", "1"},
                                                     {"command", "cat"}};
  return assess(assessment.definition, assessment.runs);
}

TEST(CostsOfStoredResults, AreToldAsThoseOfAnotherMachine) {
  const CaseAssessment assessment = with_a_stored_result();
  EXPECT_EQ(assessment.runs.status.at("theirs").message,
            "stored result of their SPH 5.4: its cost was measured on another machine, one core");
  EXPECT_EQ(assessment.runs.status.at("coarse").message, "");
  EXPECT_TRUE(cost_of(assessment.runs, "theirs").elsewhere);
  EXPECT_FALSE(cost_of(assessment.runs, "coarse").elsewhere);
  const auto figures = cost_figures(assessment);
  ASSERT_FALSE(figures.empty());
  EXPECT_NE(figures[0].caption.find("Stored results, with costs of other machines: theirs."),
            std::string::npos)
      << figures[0].caption;
  const reports::Table origin = provenance_table(assessment);
  const auto theirs = std::find_if(origin.rows.begin(), origin.rows.end(),
                                   [](const auto& row) { return row.at(0) == "theirs"; });
  ASSERT_NE(theirs, origin.rows.end());
  EXPECT_EQ(theirs->at(1), "their SPH 5.4, computed elsewhere, read by Slosh 1");
  EXPECT_EQ(theirs->at(2), "2026-11-22, one core. Built by themselves.");
}

TEST(CostToReach, IsJudgedOfAnExternalProgramsMethodAsOfAScheme) {
  const GateRow row = cost_row(0.1, 20);
  const GateOutcome of_program =
      judged({row}, five_timings(), three_resolutions_of_a_program()).gate.at(0);
  EXPECT_EQ(of_program.verdict, Verdict::pass) << of_program.message;
  EXPECT_DOUBLE_EQ(of_program.value.value, judge(row, five_timings()).value.value);
}

TEST(MeasuredCost, IsTheMeanOfTimingsWithStudentsIntervalAndElseTheCampaignsOwn) {
  CaseRuns runs;
  runs.results["run"].cost = cost(100);
  EXPECT_EQ(cost_of(runs, "run").core_seconds.value, 100);
  EXPECT_EQ(cost_of(runs, "run").timings, 0U);
  EXPECT_TRUE(std::isnan(cost_of(runs, "run").core_seconds.half_width));
  runs.timings["run"] = {cost(9)};
  EXPECT_EQ(cost_of(runs, "run").core_seconds.value, 9);
  EXPECT_FALSE(cost_of(runs, "run").has_interval());
  EXPECT_TRUE(std::isnan(cost_of(runs, "run").core_seconds.half_width));
  runs.timings["run"] = {cost(9), cost(10), cost(11)};
  const MeasuredCost found = cost_of(runs, "run");
  EXPECT_NEAR(found.core_seconds.value, 10, 1e-12);
  EXPECT_NEAR(found.core_seconds.half_width, 4.3027 / std::sqrt(3), 1e-4);  // tables, 2 degrees
  EXPECT_EQ(found.memory.half_width, 0);
  EXPECT_EQ(found.timings, 3U);
}

TEST(WorkFamilies, AreOfRunsThatDifferInResolutionAloneCoarseToFine) {
  for (const auto& [assessment, name, other] :
       {std::tuple{&three_resolutions(), "recommended", "recommended, antuono"},
        {&three_resolutions_of_a_program(), "my_sph", "other"}}) {
    const auto families = work_families(*assessment);
    ASSERT_EQ(families.size(), 2U);
    EXPECT_EQ(families[0].name, name);
    EXPECT_EQ(families[0].reference, "theory");
    ASSERT_EQ(families[0].runs.size(), 3U);
    EXPECT_EQ(families[0].runs.front().run, "coarse");
    EXPECT_EQ(families[0].runs.back().run, "fine");
    EXPECT_EQ(families[1].name, other);
  }
}

TEST(WorkFamilies, ShowReferencesByWhatSetsThemApart) {
  CaseDefinition definition = surge_case();
  RunDefinition flow = sample_run(PotentialRun{});
  flow.name = "flow";
  definition.runs.push_back(flow);
  CaseRuns runs = surge_runs();
  TimeSeries higher = elevation_of({});
  for (double& value : higher.value) value *= 1.02;
  runs.results["flow"] = result_of("flow", higher);
  runs.results["flow"].diagnostics = {{"valid_until_s", 20}};
  runs.status["flow"] = {RunState::finished, ""};
  const auto families = reference_families(assess(definition, runs));
  ASSERT_EQ(families.size(), 2U);  // the theory with the gas has no other of its kind
  EXPECT_EQ(families[0].name, "theory");
  EXPECT_EQ(families[0].reference, "flow");
  EXPECT_EQ(families[1].name, "flow");
  EXPECT_EQ(families[1].reference, "theory");
  EXPECT_NEAR(families[1].runs.at(0).error.value, 0.02, 1e-3);
  EXPECT_TRUE(reference_families(three_resolutions()).empty());  // one alone
}

TEST(CostRow, PassesWhereTheErrorIsReachedCheaplyAndFailsWhereAllCostMore) {
  // 7 % lies half way, in the logarithm, between 10 and 5 %: 8 times the root of 8 seconds.
  const GateOutcome cheap = judge(cost_row(0.0707, 30), five_timings());
  EXPECT_EQ(cheap.verdict, Verdict::pass) << cheap.message;
  EXPECT_NEAR(cheap.value.value, 8 * std::sqrt(8), 0.05);
  EXPECT_GT(cheap.value.half_width, 0.01 * cheap.value.value);
  EXPECT_LT(cheap.value.half_width, 0.03 * cheap.value.value);
  EXPECT_EQ(judge(cost_row(0.0707, 30), five_timings(1.31)).verdict, Verdict::inconclusive);
  EXPECT_EQ(judge(cost_row(0.0707, 30), five_timings(1.5)).verdict, Verdict::violated);
}

// Rows on the same runs, judged together.
TEST(CostRow, FailsWhereNoRunOfTheFamilyReachesTheErrorWhichIsNotExtrapolated) {
  const auto gate = judged({cost_row(0.02, 1000), cost_row(0.04, 1e6)}, five_timings()).gate;
  for (const GateOutcome& outcome : gate) {
    EXPECT_EQ(outcome.verdict, Verdict::violated);
    EXPECT_EQ(outcome.message.find("not reached (5"), 0U) << outcome.message;
  }
}

TEST(CostRow, IsNotComparedWhereARunThatItRestsOnWasNotTimedTwiceAlone) {
  const GateOutcome outcome = judge(cost_row(0.0707, 30), {});
  EXPECT_EQ(outcome.verdict, Verdict::not_compared);
  EXPECT_NE(
      outcome.message.find("medium and fine were not timed twice or more on a core of their own"),
      std::string::npos)
      << outcome.message;
  Timings once = five_timings(), without_coarse = once, poisoned = once;
  once["fine"].resize(1);
  EXPECT_EQ(judge(cost_row(0.0707, 30), once).verdict, Verdict::not_compared);
  without_coarse.erase("coarse");  // the row rests on the two others
  EXPECT_EQ(judge(cost_row(0.0707, 30), without_coarse).verdict, Verdict::pass);
  for (auto& [run, costs] : poisoned) costs.front().user_time = nan;
  EXPECT_EQ(judge(cost_row(0.0707, 30), poisoned).verdict, Verdict::violated);
}

TEST(CostRow, IsNotComparedWhereItsCandidateIsNoNumberAndLeftOutWithTheRunsThatReachIt) {
  CaseAssessment poisoned = three_resolutions(), left_out = poisoned;
  poisoned.runs.results.at("medium").series.at(0).value.at(250) = nan;
  EXPECT_EQ(judged({cost_row(0.0707, 30)}, five_timings(), poisoned).gate.at(0).verdict,
            Verdict::not_compared);
  left_out.runs.results.erase("fine");
  left_out.runs.status["fine"] = {RunState::not_selected, ""};
  const auto gate =
      judged({cost_row(0.0707, 30), cost_row(0.15, 30)}, five_timings(), left_out).gate;
  EXPECT_EQ(gate.at(0).verdict, Verdict::not_selected);
  EXPECT_NE(gate.at(0).message.find("fine"), std::string::npos);
  EXPECT_EQ(gate.at(1).verdict, Verdict::pass) << gate.at(1).message;
}

TEST(CostRow, IsReportedWithAllOthersAndAsksForTimingsWhereItIsInconclusive) {
  CaseAssessment assessment = judged({cost_row(0.0707, 30)}, five_timings(1.31));
  assessment.definition.refinements = {
      {"spacing", RefinedNumber::particle_spacing, {"coarse", "medium", "fine"}}};
  EXPECT_TRUE(refinement_table(assessment).rows.empty());  // the cost is no metric of one run
  EXPECT_NE(remedy_table(assessment).rows.at(0).back().find("times as many timings"),
            std::string::npos);
}

TEST(CostRow, DetectsASpoiledSeries) {
  const auto sensitivity = gate_sensitivity(judged({cost_row(0.0707, 30)}, five_timings()));
  ASSERT_EQ(sensitivity.size(), 1U);
  EXPECT_TRUE(sensitivity[0].passes_as_it_is);
  EXPECT_TRUE(blind_rows(sensitivity).empty());
  EXPECT_TRUE(sensitivity[0].detects.at(Spoiling::not_a_number));
}

TEST(CostFigures, HaveBarsWhereRunsWereTimedAndSayWhereTheyWereNot) {
  Timings timings = five_timings();
  timings.erase("coarse");
  const reports::Figure figure = figure_of(judged({}, timings), "cost");
  const reports::Curve& family = figure.curves.at(1);
  EXPECT_EQ(family.label.find("recommended, slope -0."), 0U) << family.label;
  EXPECT_EQ(family.style, reports::Curve::Style::line_points);
  ASSERT_EQ(family.x_error.size(), 3U);
  EXPECT_TRUE(std::isnan(family.x_error[0]));
  EXPECT_NEAR(family.x_error[2] / 64, 2.7764 * 0.02 / std::sqrt(5), 1e-3);  // tables, 4 degrees
  EXPECT_NE(figure.caption.find("without a bar of cost: coarse, changed."), std::string::npos)
      << figure.caption;
  EXPECT_TRUE(figure_of(judged({}, {}), "cost").curves.at(1).x_error.empty());
}

TEST(CostFigures, DrawTheFrontOfAllCandidatesInStepsAndShowMemoryInMebibytes) {
  const reports::Curve front = figure_of(three_resolutions(), "cost").curves.front();
  EXPECT_EQ(front.label, "Pareto front");
  EXPECT_EQ(front.x, (std::vector<double>{1, 1, 8, 8, 64, 64, 64}));
  ASSERT_EQ(front.y.size(), 7U);
  EXPECT_NEAR(front.y[0], 0.3, 2e-3);  // of the run that is not on it
  EXPECT_EQ(front.y[1], front.y[2]);
  EXPECT_EQ(front.y[5], front.y[6]);
  EXPECT_EQ(figure_of(three_resolutions(), "memory").curves.at(1).x,
            (std::vector<double>{16, 32, 64}));
}

TEST(CostTable, TellsWhatEachErrorCostsAndWhereItIsNotReached) {
  const auto tables = work_precision_tables(judged({}, five_timings()));
  const reports::Table& table = table_named(tables, "cost-to-reach");
  ASSERT_EQ(table.rows.size(), 1U);  // one change of one resolution is no family to tell
  const auto& row = table.rows[0];
  EXPECT_EQ(row[0], "recommended");
  EXPECT_EQ(row[2], "alone, 5 times");
  EXPECT_EQ(row[4], "-0.333");  // the points lie on a line: its interval changes no digit
  EXPECT_EQ(row[5].find("8 s ("), 0U) << row[5];
  EXPECT_EQ(row[6].find("extrapolated: 6"), 0U) << row[6];
  EXPECT_EQ(row[7].find("not reached (5"), 0U) << row[7];
  EXPECT_NE(table.caption.find("Measured on none; compiler none, flags unknown"), std::string::npos)
      << table.caption;
  const auto memory = work_precision_tables(three_resolutions());
  EXPECT_EQ(table_named(memory, "memory-to-reach").rows.at(0).at(5).find("32 MiB"), 0U);
  EXPECT_EQ(table_named(memory, "memory-to-reach").rows[0][2],
            "once, while other runs were running");
}

// SPH at 20, 10 and 5 % in 1, 8 and 64 s; a mesh at 16 and 8 % in 40 and 80 s.
CaseAssessment beside_meshes(std::vector<ScaledRun> runs) {
  runs.push_back({"coarse_mesh", InterFoamRun{50, 50, 1}, 1.16, cost(40)});
  runs.push_back({"fine_mesh", InterFoamRun{50, 100, 1}, 1.08, cost(80)});
  return assess_scaled(runs);
}

TEST(SpeedAtEqualError, IsAtTheSmallestErrorThatBothCurvesReach) {
  const auto speeds = equal_error_speeds(beside_meshes(three_particles));
  ASSERT_EQ(speeds.size(), 1u);
  EXPECT_NEAR(speeds[0].error, 0.08, 1e-5);
  const double own = 8 * std::pow(8, std::log(0.1 / 0.08) / std::log(2));  // on the chord
  EXPECT_NEAR(speeds[0].value, 80 / own, 1e-3);
  EXPECT_FALSE(speeds[0].is_repeated);
  EXPECT_EQ(speed_text(speeds[0]),
            "SPH: 5.1 times the speed of interFoam at equal error (8 %), 5.1 to 5.1 beside the "
            "scatter of costs that were measured once");
  const auto figure = speed_figure(beside_meshes(three_particles));
  ASSERT_TRUE(figure);
  EXPECT_EQ(figure->caption.find("SPH: 5.1 times"), 0u);
}

TEST(SpeedAtEqualError, IsNotToldWhereACurveDoesNotReachTheError) {
  EXPECT_TRUE(equal_error_speeds(
                  beside_meshes({{"fine", SphRun{"recommended", 0.005, 0.005}, 1.05, cost(64)}}))
                  .empty())
      << "a bound";
  EXPECT_TRUE(equal_error_speeds(three_resolutions()).empty()) << "no mesh";
  EXPECT_FALSE(speed_figure(three_resolutions()));
}

TEST(SpeedAtEqualError, TellsTheSpreadOfTheCostsThatWereRepeated) {
  const CaseAssessment one = beside_meshes(three_particles);
  CaseRuns runs = one.runs;
  runs.timings = five_timings();
  for (const double share : {0.9, 1.0, 1.1}) runs.timings["fine_mesh"].push_back(cost(80 * share));
  const auto speeds = equal_error_speeds(assess(one.definition, runs));
  ASSERT_EQ(speeds.size(), 1u);
  EXPECT_TRUE(speeds[0].is_repeated);
  EXPECT_GT(speeds[0].spread, 0.24) << "of three timings by 10 %: t = 4.30, over the root of 3";
  EXPECT_LT(speeds[0].spread, 0.27);
}

// All runs err more at the begin, so that the errors of another window are others, but not how they
// compare.
TEST(SpeedAtEqualError, IsNotMadeUncertainByAStretchWhereAllRunsErrMore) {
  const CaseAssessment even = beside_meshes(three_particles);
  CaseRuns runs = even.runs;
  const std::vector<double> theory = runs.results.at("theory").series.at(0).value;
  const auto spoil = [&](const std::string& run, double later) {
    TimeSeries& series = runs.results.at(run).series.at(0);
    for (std::size_t i = 0; i < theory.size(); ++i)
      if (series.time[i] > 10) series.value[i] = std::lerp(theory[i], series.value[i], later);
  };
  for (const char* run : {"coarse", "medium", "fine", "coarse_mesh", "fine_mesh"}) spoil(run, 0.3);
  const auto together = equal_error_speeds(assess(even.definition, runs));
  ASSERT_EQ(together.size(), 1u);
  EXPECT_NEAR(together[0].value, equal_error_speeds(even).at(0).value, 0.02);
  EXPECT_LT(together[0].spread, 0.02);
  spoil("fine_mesh", 0.3);  // now one of them alone is better there
  const auto apart = equal_error_speeds(assess(even.definition, runs));
  ASSERT_EQ(apart.size(), 1u);
  EXPECT_GT(apart[0].spread, 0.1);
}

TEST(ResultsJson, TellTimingsAndWorkPrecision) {
  const auto document = nlohmann::json::parse(
      results_json("c", false, {judged({cost_row(0.1, 30)}, five_timings())}));
  const auto& one = document.at("cases").at(0);
  EXPECT_EQ(one.at("gate").at(0).at("error"), 0.1);
  for (const auto& run : one.at("runs"))
    if (run.at("name") == "fine") {
      EXPECT_EQ(run.at("timings").size(), 5U);
    }
  const auto& family = one.at("work_precision").at(0);
  EXPECT_EQ(family.at("family"), "recommended");
  EXPECT_EQ(family.at("runs").size(), 3U);
  EXPECT_NEAR(family.at("slope_over_core_seconds").at("value").get<double>(), -1.0 / 3, 0.01);
  const auto& levels = family.at("core_seconds_to_reach");
  EXPECT_EQ(levels.at(0).at("reach"), "interpolated");
  EXPECT_EQ(levels.at(3).at("reach"), "not reached");
  EXPECT_TRUE(levels.at(3).at("core_seconds_s").is_null());
}

}  // namespace
}  // namespace slosh::work_points_test
