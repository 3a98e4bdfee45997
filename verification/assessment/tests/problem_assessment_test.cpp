// The gate of problems: every metric passes what it should and fails scaled errors, errors that do
// not converge and errors that are no number; the report, the JSON and the exit status tell of it.
#include "verification/assessment/problem_assessment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "reports/pages/write_report.hpp"
#include "reports/summary/headline.hpp"
#include "reports/summary/report_sections.hpp"
#include "reports/summary/results_json.hpp"
#include "verification/case_file/campaign_parser.hpp"
#include "verification/problems/problem_list.hpp"

namespace slosh::problem_assessment_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Second order: 0.04, 0.01, 0.0025, times a factor.
std::vector<ErrorAtStep> second_order(double factor = 1) {
  return {{0.2, 0.04 * factor}, {0.1, -0.01 * factor}, {0.05, 0.0025 * factor}};
}

ProblemGateRow row_on(ProblemMetric metric, double limit) {
  return {"velocity", metric, "1", limit, {}, "", "", {"trial.toml", 7}};
}
ProblemGateRow order_row(double lower, double upper) {
  ProblemGateRow row = row_on(ProblemMetric::order_within, 0);
  row.limit.reset();
  row.between = {lower, upper};
  return row;
}

ProblemRun run_with(std::vector<ErrorAtStep> errors) {
  ProblemResult result;
  result.problem = "taylor_green";
  result.outcome.measures = {{"velocity", std::move(errors)}};
  return {{RunState::finished, ""}, std::move(result)};
}

Verdict verdict(const ProblemGateRow& row, std::vector<ErrorAtStep> errors) {
  return evaluate(row, run_with(std::move(errors))).verdict;
}

const std::vector<ProblemGateRow> rows{
    row_on(ProblemMetric::order_at_least, 1.9), order_row(1.9, 2.1),
    row_on(ProblemMetric::error_at_finest, 0.0026), row_on(ProblemMetric::largest_error, 0.041)};

TEST(ProblemGate, PassesErrorsWithinEveryBound) {
  for (const ProblemGateRow& row : rows) EXPECT_EQ(verdict(row, second_order()), Verdict::pass);
  const ProblemGateOutcome outcome = evaluate(rows[0], run_with(second_order()));
  EXPECT_NEAR(outcome.value, 2, 1e-12);
  EXPECT_EQ(outcome.message, "2 >= 1.9");
}

TEST(ProblemGate, FailsErrorsThatAreScaledAndAnOrderThatAConstantErrorSpoils) {
  for (const std::size_t i : {2u, 3u})
    EXPECT_EQ(verdict(rows[i], second_order(1.05)), Verdict::violated) << i;
  std::vector<ErrorAtStep> spoilt = second_order();
  for (ErrorAtStep& one : spoilt) one.error = std::abs(one.error) + 0.05;
  for (const ProblemGateRow& row : rows) EXPECT_EQ(verdict(row, spoilt), Verdict::violated);
  EXPECT_EQ(verdict(order_row(0.5, 1.9), second_order()), Verdict::violated) << "too high an order";
  EXPECT_EQ(verdict(order_row(2.1, 3), second_order()), Verdict::violated) << "too low an order";
  const ProblemGateRow finest = row_on(ProblemMetric::error_at_finest, 0.0026);  // in any order
  EXPECT_EQ(verdict(finest, {{0.05, 0.0025}, {0.2, 0.04}, {0.1, 0.01}}), Verdict::pass);
  EXPECT_EQ(verdict(finest, {{0.05, 0.04}, {0.2, 0.0025}, {0.1, 0.01}}), Verdict::violated);
}

TEST(ProblemGate, FailsAnErrorThatIsNoNumberAtAnyResolution) {
  for (const ProblemGateRow& row : rows)
    for (std::size_t i = 0; i < 3; ++i)
      for (const double bad : {nan, std::numeric_limits<double>::infinity()}) {
        std::vector<ErrorAtStep> errors = second_order();
        errors[i].error = bad;
        EXPECT_EQ(verdict(row, errors), Verdict::violated) << i;
      }
  EXPECT_FALSE(order_of({{0.4, nan}, {0.2, 4}, {0.1, 1}, {0.05, 0.25}}));
}

TEST(ProblemGate, ComparesNothingWithoutErrorsOrWithTooFewForAnOrder) {
  for (const ProblemGateRow& row : rows) EXPECT_EQ(verdict(row, {}), Verdict::not_compared);
  for (const std::size_t i : {0u, 1u})
    EXPECT_EQ(verdict(rows[i], {{0.2, 0.04}, {0.1, 0.01}, {0.05, 0}}), Verdict::not_compared);
  ProblemGateRow other = rows[0];
  other.measure = "decay_rate";
  EXPECT_EQ(verdict(other, second_order()), Verdict::not_compared);
}

const ProblemDefinition eddy{"taylor_green", rows};

TEST(ProblemAssessment, CountsInTheExitStatusAndTheVerdictSentence) {
  const ProblemAssessment good = assess(eddy, run_with(second_order())),
                          bad = assess(eddy, run_with(second_order(1.05))),
                          failed = assess(eddy, {{RunState::failed, "exit status 3"}, {}}),
                          missing = assess(eddy, {{RunState::missing, "not there"}, {}});
  EXPECT_EQ(exit_status({}, {good}), exit_pass);
  EXPECT_EQ(exit_status({}, {good, bad}), exit_violated);
  EXPECT_EQ(exit_status({}, {good, failed, bad}), exit_solver_failed);
  EXPECT_EQ(exit_status({}, {good, missing}), exit_not_compared);
  EXPECT_EQ(exit_status({}, std::vector<ProblemAssessment>{}), exit_not_compared);
  EXPECT_EQ(verdict_sentence({}, {good}), "4 of 4 gate rows hold.");
  EXPECT_EQ(verdict_sentence({}, {bad}), "2 of 4 gate rows hold, 2 violated.");
  EXPECT_EQ(verdict_sentence({}, {missing}),
            "0 of 4 gate rows hold, 4 not compared, 1 run without a result.");
}

// All measures of the problem, as a run leaves them.
ProblemRun whole_run() {
  ProblemRun run = run_with(second_order());
  run.result->outcome.measures.clear();
  for (const MeasureKind& kind : find_problem("taylor_green").measures)
    run.result->outcome.measures.push_back({kind.name, second_order()});
  return run;
}

TEST(ProblemAssessment, IsASectionOfTheReportWithItsErrorsAndLimits) {
  CampaignDefinition campaign;
  campaign.name = campaign.title = "trial";
  campaign.source = "none";
  const reports::Report report =
      campaign_report(campaign, false, "./slosh", {}, {assess(eddy, whole_run())});
  EXPECT_NO_THROW(reports::check_report(report));
  EXPECT_EQ(report.outcome, reports::Outcome::pass);
  ASSERT_EQ(report.sections.size(), 3u);
  EXPECT_EQ(report.sections[0].tables.at(0).id, "headline");
  EXPECT_EQ(report.sections[1].tables.at(0).rows.size(), 4u);  // worst first
  ASSERT_EQ(report.pages.size(), 1u);
  EXPECT_EQ(report.pages[0].id, "problems");
  const reports::Section& section = report.sections[2];
  EXPECT_EQ(section.page, "problems");
  EXPECT_EQ(section.id, "problem-taylor_green");
  ASSERT_EQ(section.tables.size(), 2u);
  EXPECT_EQ(section.tables[0].rows.size(), find_problem("taylor_green").measures.size());
  EXPECT_EQ(section.tables[0].rows[0].at(4), "0.04; -0.01; 0.0025");
  EXPECT_EQ(section.tables[0].rows[0].at(7), "2.00");
  EXPECT_FALSE(section.figures.empty());
  for (const reports::Figure& figure : section.figures) EXPECT_LE(figure.curves.size(), 6u);
}

TEST(ProblemAssessment, IsInTheJsonWithItsErrorsAndVerdicts) {
  const auto document =
      nlohmann::json::parse(results_json("trial", false, {}, {assess(eddy, whole_run())}));
  EXPECT_EQ(document.at("exit_status"), 0);
  const auto& problem = document.at("problems").at(0);
  EXPECT_EQ(problem.at("name"), "taylor_green");
  EXPECT_EQ(problem.at("state"), "finished");
  EXPECT_EQ(problem.at("measures").at(0).at("errors").at(1).at("error"), -0.01);
  EXPECT_NEAR(problem.at("measures").at(0).at("order"), 2, 1e-12);
  EXPECT_EQ(problem.at("gate").at(0).at("verdict"), "pass");
  EXPECT_EQ(problem.at("gate").at(0).at("line"), 7);
}

// "measured" and nothing before it: what no theory, experiment or requirement gives.
TEST(ProblemGate, CallsEachShippedRowOnAMeasuredLimitARegressionRow) {
  const std::filesystem::path shipped = std::filesystem::path(SLOSH_SOURCE_DIR) / "verification";
  int regressions = 0;
  for (const char* name : {"verification", "stability"}) {
    const auto campaign = read_campaign(find_campaign(name, shipped / "campaigns"),
                                        shipped / "cases", known_problems());
    for (const ProblemDefinition& problem : campaign.problems)
      for (const ProblemGateRow& row : problem.gate) {
        const bool measured = row.source.starts_with("measured") ||
                              row.source.starts_with("the quick form's finest; measured");
        EXPECT_EQ(row.kind == RowKind::regression, measured)
            << problem.name << " " << row.measure << ": " << row.source;
        regressions += measured;
      }
  }
  EXPECT_EQ(regressions, 7);
}

}  // namespace
}  // namespace slosh::problem_assessment_test
