// The cost of all runs and problems of a campaign together.
#include "verification/assessment/campaign_cost.hpp"

#include <gtest/gtest.h>

#include "verification/tests/surge_results.hpp"

namespace slosh::campaign_cost_test {
namespace {

RunResult taking(double user_time, double system_time) {
  RunResult result;
  static int made = 0;
  result.key = std::to_string(++made);
  result.cost = {.wall_time = 9, .user_time = user_time, .system_time = system_time};
  return result;
}

// Two runs of this cost each.
CaseAssessment with_runs(double user_time, double system_time) {
  CaseAssessment assessment{surge_case(), {}, {}, {}, {}};
  assessment.definition.runs.resize(2);
  for (std::size_t i = 0; i < 2; ++i) {
    RunDefinition& run = assessment.definition.runs[i];
    run.name = i == 0 ? "coarse" : "fine";
    run.solver = SphRun{"recommended", 0.02, 0.02};
    assessment.runs.results[run.name] = taking(user_time, system_time);
  }
  return assessment;
}

TEST(CampaignCost, CountsUserAndSystemTimeOfAllRunsAndProblems) {
  ProblemRun run{{RunState::finished, ""}, ProblemResult{}};
  run.result->cost = {.user_time = 500, .system_time = 100};
  run.result->key = "a problem";
  const ProblemAssessment made{{}, run, {}}, missing{{}, {{RunState::missing, ""}, {}}, {}};
  const std::vector<CaseAssessment> cases{with_runs(4000, 200), with_runs(30, 1)};
  const CampaignCost cost = campaign_cost(cases, {made, missing});
  EXPECT_EQ(cost.results, 5u);
  EXPECT_DOUBLE_EQ(cost.core_seconds, 2 * 4200 + 2 * 31 + 600);
  EXPECT_EQ(cost_sentence(cases, {made, missing}),
            "The results of the campaign cost 9062 core-seconds (2.5 hours). This is the sum over "
            "its runs and "
            "problems, 5 in all, each measured when it was made.");
}

TEST(CampaignCost, CountsRunsAtTheBoundsOfAnInputNoPredictionsAndASharedRunOnce) {
  CaseAssessment assessment = with_runs(30, 1), other = with_runs(5, 0);
  other.runs.results["coarse"] = assessment.runs.results.at("coarse");
  EXPECT_DOUBLE_EQ(campaign_cost({assessment, other}, {}).core_seconds, 2 * 31 + 5);
  RunResult theory = taking(50, 0);
  theory.key = "";
  assessment.runs.input_bounds[Input::density] = {taking(7, 1), taking(8, 1)};
  assessment.runs.input_bounds[Input::amplitude] = {theory, theory};
  EXPECT_DOUBLE_EQ(campaign_cost({assessment}, {}).core_seconds, 2 * 31 + 8 + 9);
}

TEST(CampaignCost, DoesNotCountStoredResultsRecordsAndTimings) {
  CaseAssessment assessment = with_runs(30, 1);
  assessment.definition.runs.resize(3);
  assessment.definition.runs[1].solver = StoredRun{};
  assessment.definition.runs[2].solver = RecordRun{};
  assessment.definition.runs[2].name = "record";
  assessment.runs.results["record"] = taking(50, 0);
  for (const char* run : {"coarse", "fine"})
    assessment.runs.timings[run] = {{.user_time = 7}, {.user_time = 8}};
  EXPECT_EQ(cost_sentence({assessment}, {}),
            "The results of the campaign cost 31.0 core-seconds (0.5 minutes). This is the sum "
            "over its runs and "
            "problems, 1 in all, each measured when it was made.");
  EXPECT_EQ(cost_sentence({CaseAssessment{surge_case(), {}, {}, {}, {}}}, {}), "");
}

}  // namespace
}  // namespace slosh::campaign_cost_test
