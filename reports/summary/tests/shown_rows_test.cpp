// The headline, the list of the worst rows, the verdicts of results.json, and what orders them.
#include "reports/summary/shown_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "reports/summary/headline.hpp"
#include "reports/summary/report_sections.hpp"
#include "reports/summary/results_json.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/surge_results.hpp"

namespace slosh::shown_rows_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

GateOutcome outcome(Verdict verdict, double value, double uncertainty = 0) {
  GateOutcome one{surge_row("forced", Metric::amplitude_error, "1", 0.05),
                  verdict,
                  {value, uncertainty},
                  "",
                  {}};
  if (std::isfinite(value))
    one.judgement = judge_error(value, {.time_series = uncertainty}, {-0.05, 0.05});
  return one;
}

CaseAssessment with_gate(const std::vector<GateOutcome>& gate) {
  CaseAssessment assessment{surge_case(), {}, {}, {}, gate};
  assessment.definition.gate.clear();
  for (const GateOutcome& one : gate) assessment.definition.gate.push_back(one.row);
  return assessment;
}

TEST(ErrorOverTolerance, IsTheErrorOverWhatIsAllowedWithTheIntervalOfItsVerdict) {
  const auto expect = [](const auto& share, double value, double half_width) {
    ASSERT_TRUE(share);
    EXPECT_NEAR(share->value, value, 1e-9);
    EXPECT_NEAR(share->half_width, half_width, 1e-9);
  };
  expect(error_over_tolerance(outcome(Verdict::pass, -0.04, 0.005)), 0.8, 0.1);
  GateOutcome ranged = outcome(Verdict::violated, 0.62, 0.01);
  ranged.row.limit.reset();
  ranged.row.between = {0.5, 0.6};
  expect(error_over_tolerance(ranged), 1.4, 0.2);  // the distance from its middle
  ranged.value = {0.55, 0.01};
  EXPECT_NEAR(error_over_tolerance(ranged)->value, 0, 1e-12);
  GateOutcome equal = outcome(Verdict::pass, 0.05);  // one at its level, at most two below
  equal.row.metric = Metric::peak_ks_p_value;
  equal.row.limit.reset();
  equal.row.between = {0.05, 1.0};
  for (const auto& [p, share] : {std::pair{0.05, 1.0}, {1.0, 0.05}, {1e-12, 2.0}}) {
    equal.value.value = p;
    EXPECT_NEAR(error_over_tolerance(equal)->value, share, 1e-9) << p;
  }
  EXPECT_EQ(value_text(equal.row, {1e-4, 2.84e-4}), "at most 0.0384 %");
}

TEST(ErrorOverTolerance, IsNotThereWithoutANumberOrWithoutABoundAndOfAnOrderTheLimitOverIt) {
  EXPECT_FALSE(error_over_tolerance(outcome(Verdict::not_compared, nan)));
  GateOutcome improving = outcome(Verdict::pass, 0.01);
  improving.row.limit.reset();
  improving.row.improves_on = "coarse";
  EXPECT_FALSE(error_over_tolerance(improving));
  const ProblemGateRow row{"gradient", ProblemMetric::order_at_least, "1", 1.9, {}, "", "", {}};
  const auto of_order = [&](double value) {
    return error_over_tolerance(ProblemGateOutcome{row, Verdict::violated, value, ""});
  };
  EXPECT_NEAR(of_order(3.8)->value, 0.5, 1e-12);
  EXPECT_TRUE(std::isinf(of_order(-0.2)->value));
  EXPECT_FALSE(of_order(nan));
}

TEST(VerdictMatrix, ShowsTheWorstRowOfEachMetricByVerdictAndThenByHowFarItsIntervalReaches) {
  GateOutcome natural = outcome(Verdict::pass, 0.045);
  natural.row.mode = "natural_1";
  GateOutcome lag = outcome(Verdict::violated, 3);
  lag.row.metric = Metric::phase_lag;
  lag.row.unit = "deg";
  lag.row.limit = 2;
  GateOutcome other_lag = lag;
  other_lag.verdict = Verdict::pass;
  other_lag.value = {1.99, 0};
  const auto matrix_of = [](const std::vector<GateOutcome>& gate) {
    CaseAssessment assessment = with_gate(gate);
    assessment.runs = surge_runs();
    return nlohmann::json::parse(results_json("surges", false, {assessment})).at("verdict_matrix");
  };
  const auto matrix = matrix_of({outcome(Verdict::pass, 0.01), natural, other_lag, lag});
  ASSERT_EQ(matrix.size(), 2u);
  EXPECT_EQ(matrix[0].at("metric"), "amplitude_error");
  EXPECT_EQ(matrix[0].at("rows"), 2);
  EXPECT_EQ(matrix[0].at("value"), 0.045);
  EXPECT_EQ(matrix[1].at("metric"), "phase_lag");
  EXPECT_EQ(matrix[1].at("verdict"), "violated");
  const std::vector<GateOutcome> wide{outcome(Verdict::inconclusive, 0.045, 0.01),
                                      outcome(Verdict::inconclusive, 0.01, 0.09)};
  EXPECT_EQ(matrix_of(wide)[0].at("value"), 0.01);
  EXPECT_EQ(worst_first_table({with_gate(wide)}, {}).links.at(0).at(0), "row-small_surge-2");
}

std::string word(const std::vector<CaseAssessment>& cases, int status = exit_pass) {
  return headline_word(status, headline_lines(cases, {}));
}

std::string sentence(const std::vector<CaseAssessment>& cases) {
  return headline_sentence(headline_lines(cases, {}));
}

TEST(Headline, SaysByHowMuchAndAgainstWhatAsTheRowsJudge) {
  GateOutcome lag = outcome(Verdict::pass, 0.5, 0.1);
  lag.row.metric = Metric::phase_lag;
  lag.row.unit = "deg";
  GateOutcome mesh = outcome(Verdict::pass, 0.02, 0.001);
  mesh.row.candidate = "fine_mesh";
  mesh.row.reference = "theory_with_gas";
  const std::vector<CaseAssessment> cases{
      with_gate({outcome(Verdict::pass, 0.0123, 0.004), lag, mesh})};
  EXPECT_EQ(sentence(cases),
            "SPH at 10 mm against linear theory: amplitude 1.2 ± 0.4 %, lag 0.50 ± 0.10 deg; "
            "interFoam at 50 x 100 cells against linear theory with the gas: amplitude 2.00 ± 0.10 "
            "%.");
  const auto lines = headline_lines(cases, {});
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].standing, "validated");
  EXPECT_EQ(lines[0].row_id, "small_surge-2") << "the nearest to its limit";
  EXPECT_EQ(word(cases), "PASS");
}

TEST(Headline, OfRegressionRowsAloneIsWatchedAndNoPass) {
  GateOutcome known = outcome(Verdict::pass, 0.0123, 0.004);
  known.row.kind = RowKind::regression;
  GateOutcome own = outcome(Verdict::pass, 0.001);  // a limit of its own validates nothing
  own.row.metric = Metric::noise_share;
  own.row.reference.clear();
  const std::vector<CaseAssessment> watched{with_gate({known, own})};
  EXPECT_EQ(headline_lines(watched, {}).at(0).standing, "watched, not validated");
  EXPECT_EQ(word(watched), "WATCHED, NOT VALIDATED");
  EXPECT_EQ(headline_lines({with_gate({own})}, {}).at(0).standing, "limits kept");
  EXPECT_EQ(word({with_gate({own})}), "PASS");
  EXPECT_EQ(word({watched[0], with_gate({outcome(Verdict::pass, 0.01)})}), "PASS");
  known.verdict = Verdict::violated;
  EXPECT_EQ(word({with_gate({known})}, exit_violated), "FAIL");
  ProblemAssessment drop;
  drop.definition.name = "drop";
  ProblemGateRow row{"period", ProblemMetric::largest_error, "1", 0.1, {}, "", "", {}};
  row.kind = RowKind::regression;
  drop.gate = {{row, Verdict::pass, 0.05, "0.05 <= 0.1"}};
  EXPECT_EQ(headline_lines({}, {drop}).at(0).standing, "watched, not validated");
  row.kind = RowKind::validation;
  drop.gate.push_back({row, Verdict::pass, 0.05, "0.05 <= 0.1"});
  EXPECT_EQ(headline_lines({}, {drop}).at(0).standing, "validated");
}

TEST(Headline, ComparesTheRunsWhereNoRowJudgesANumber) {
  CaseDefinition definition = surge_case();
  definition.gate = {surge_row("forced", Metric::phase_lag, "deg", 2)};
  CaseRuns runs = surge_runs_with("particles", scaled(elevation_of({}), 1.02));
  const auto lines = headline_lines({assess(definition, runs)}, {});
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].amplitude, "2 %");
  EXPECT_TRUE(begins(lines[0].rms, "2"));
}

TEST(Headline, LeadsWithTheRunThatARowObjectsTo) {
  GateOutcome coarse = outcome(Verdict::violated, 0.2, 0.01);
  CaseAssessment bad = with_gate({outcome(Verdict::pass, 0.01), coarse});
  RunDefinition run = run_named(bad.definition, "particles");
  run.name = "coarse_particles";
  std::get<SphRun>(run.solver).particle_spacing = 0.025;
  bad.definition.runs.push_back(run);
  bad.gate[1].row.candidate = run.name;
  bad.definition.name = "another_surge";
  EXPECT_EQ(sentence({with_gate({outcome(Verdict::pass, 0.01)}), bad}),
            "SPH at 25 mm against linear theory: amplitude 20.0 ± 1.0 %.");
  EXPECT_EQ(headline_lines({bad}, {}).at(0).standing, "violated");
  EXPECT_EQ(headline_lines({with_gate({outcome(Verdict::not_compared, nan)})}, {}).at(0).standing,
            "not compared");
}

TEST(WorstFirst, IsByVerdictAndThenByHowFarTheIntervalReaches) {
  const reports::Table table = worst_first_table(
      {with_gate({outcome(Verdict::pass, 0.048), outcome(Verdict::inconclusive, 0.01, 0.06),
                  outcome(Verdict::inconclusive, 0.045, 0.01), outcome(Verdict::solver_failed, nan),
                  outcome(Verdict::pass, 0.044, 0.005), outcome(Verdict::violated, 0.2, 0.01),
                  outcome(Verdict::not_compared, nan), outcome(Verdict::violated, 0.06),
                  outcome(Verdict::not_selected, nan)})},
      {});
  std::vector<std::string> links;
  for (const auto& row : table.links) links.push_back(row[0].substr(16));
  EXPECT_EQ(links, (std::vector<std::string>{"4", "6", "8", "7", "2", "3", "5", "1"}));
  EXPECT_EQ(table.rows.at(1).at(1), "400 ± 20");
  EXPECT_EQ(table.rows.at(3).at(1), "");
  std::vector<GateOutcome> gate(4, outcome(Verdict::pass, 0.01));  // which alone are left out
  gate.insert(gate.end(), 3, outcome(Verdict::violated, 0.1));
  const reports::Table cut = worst_first_table({with_gate(gate)}, {}, 2);
  EXPECT_EQ(cut.rows.size(), 3u);
  EXPECT_TRUE(holds(cut.caption, "3 of the 7 rows"));
}

TEST(DecisionOf, NamesTheWorstRowOfACodeUnderTestBeforeOneOfOpenFoam) {
  GateOutcome mesh = outcome(Verdict::violated, 0.9);
  mesh.row.candidate = "fine_mesh";
  ASSERT_TRUE(std::holds_alternative<InterFoamRun>(run_named(surge_case(), "fine_mesh").solver));
  const auto decided_by = [](const std::vector<GateOutcome>& gate) {
    return decision_of({with_gate(gate)}, {}).row.anchor;
  };
  EXPECT_EQ(decided_by({mesh, outcome(Verdict::violated, 0.06)}), "row-small_surge-2");
  EXPECT_EQ(decided_by({mesh, outcome(Verdict::inconclusive, 0.04, 0.02)}), "row-small_surge-1");
}

TEST(SensitivityTable, HasAColumnPerSpoiling) {
  const CaseAssessment assessment = with_gate({});
  const GateRow row = surge_row("forced", Metric::amplitude_error, "1", 0.05);
  const reports::Table table = sensitivity_table(
      assessment,
      {{row, false, {}},
       {row,
        true,
        {{Spoiling::amplitude, true}, {Spoiling::lag, false}, {Spoiling::noise, true}}}});
  EXPECT_EQ(table.id, "small_surge-strength");
  ASSERT_EQ(table.rows.at(0).size(), table.header.size());
  EXPECT_EQ(table.rows[0].front(), "particles, forced amplitude_error of elevation@right");
  EXPECT_EQ(table.rows[0].back(), "does not pass as it is");
  EXPECT_EQ(table.rows[1][1], "detected");
  EXPECT_EQ(table.rows[1][2], "not detected");
  EXPECT_EQ(table.rows[1][3], "not applicable");
}

TEST(CoverageTable, NamesWhatTheRowsOfACaseMiss) {
  CaseCoverage coverage{"surge", "", 3, 2, {}};
  for (const RequiredDetection& one : required_detections)
    coverage.detections[one.spoiling] = {Coverage::detected, {}};
  coverage.detections[Spoiling::noise] = {Coverage::missed, {}};
  const reports::Table table = coverage_table("coverage", {coverage});
  EXPECT_EQ(table.rows.at(0), (std::vector<std::string>{"surge", "2", "3", "detected", "detected",
                                                        "detected", "MISSED", "detected"}));
}

}  // namespace
}  // namespace slosh::shown_rows_test
