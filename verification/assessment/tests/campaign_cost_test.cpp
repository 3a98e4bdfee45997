// The cost of all runs and problems of a campaign together.
#include "verification/assessment/campaign_cost.hpp"

#include <gtest/gtest.h>

#include "verification/tests/surge_results.hpp"

namespace slosh::campaign_cost_test {
namespace {

CaseAssessment with_runs(double user_time, double system_time) {
  CaseAssessment assessment{surge_case(), {}, {}, {}, {}};
  for (const char* run : {"coarse", "fine"}) {
    RunResult result;
    result.cost = {.wall_time = 9, .user_time = user_time, .system_time = system_time};
    assessment.runs.results[run] = result;
  }
  return assessment;
}

TEST(CampaignCost, CountsUserAndSystemTimeOfAllRunsAndProblems) {
  ProblemRun run{{RunState::finished, ""}, ProblemResult{}};
  run.result->cost = {.user_time = 500, .system_time = 100};
  const ProblemAssessment made{{}, run, {}}, missing{{}, {{RunState::missing, ""}, {}}, {}};
  const CampaignCost cost =
      campaign_cost({with_runs(4000, 200), with_runs(30, 1)}, {made, missing});
  EXPECT_EQ(cost.results, 5u);
  EXPECT_DOUBLE_EQ(cost.core_seconds, 2 * 4200 + 2 * 31 + 600);
  EXPECT_EQ(
      cost_sentence({with_runs(4000, 200), with_runs(30, 1)}, {made, missing}),
      "The campaign cost 9062 core-seconds (2.5 hours): the sum over 5 results, each measured "
      "when it was made.");
}

TEST(CampaignCost, DoesNotCountStoredResultsAndTimings) {
  CaseAssessment assessment = with_runs(30, 1);
  assessment.runs.results["fine"].provenance["stored_software"] = "another code";
  assessment.runs.timings["coarse"] = {{.user_time = 7}, {.user_time = 8}};
  EXPECT_EQ(
      cost_sentence({assessment}, {}),
      "The campaign cost 31.0 core-seconds (0.5 minutes): the sum over 1 result, each measured "
      "when it was made.");
}

TEST(CampaignCost, IsNotToldWhereNothingHasRun) {
  EXPECT_EQ(cost_sentence({CaseAssessment{surge_case(), {}, {}, {}, {}}}, {}), "");
}

}  // namespace
}  // namespace slosh::campaign_cost_test
