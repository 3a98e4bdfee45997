// The ledgers of the shipped campaigns: each row that they hold is one that the campaign has, so
// that no gate on a shipped campaign ends with a lost row.
#include <gtest/gtest.h>

#include <filesystem>

#include "verification/baseline/baseline_diff.hpp"
#include "verification/baseline/baseline_ledger.hpp"
#include "verification/case_file/campaign_parser.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/problems/problem_list.hpp"

namespace slosh::shipped_ledgers_test {
namespace {

namespace fs = std::filesystem;

const fs::path verification = fs::path(SLOSH_SOURCE_DIR) / "verification";

// Every row without a value, as none is computed here.
std::vector<CaseAssessment> assessments_of(const CampaignDefinition& campaign) {
  std::vector<CaseAssessment> cases;
  for (const fs::path& file : campaign.cases) {
    CaseAssessment one{read_case(file), {}, {}, {}, {}};
    for (const GateRow& row : one.definition.gate)
      one.gate.push_back({row, Verdict::not_compared, {not_a_number, not_a_number}, ""});
    cases.push_back(std::move(one));
  }
  return cases;
}

std::vector<ProblemAssessment> problems_of(const CampaignDefinition& campaign) {
  std::vector<ProblemAssessment> problems;
  for (const ProblemDefinition& definition : campaign.problems) {
    ProblemAssessment one{definition, {}, {}};
    for (const ProblemGateRow& row : definition.gate)
      one.gate.push_back({row, Verdict::not_compared, not_a_number, ""});
    problems.push_back(std::move(one));
  }
  return problems;
}

TEST(ShippedLedgers, HoldNoRowThatTheirCampaignHasLost) {
  std::size_t rows = 0;
  for (const auto& entry : fs::directory_iterator(verification / "campaigns")) {
    if (entry.path().extension() != ".toml") continue;
    const CampaignDefinition campaign =
        read_campaign(entry.path(), verification / "cases", known_problems());
    const std::vector<CaseAssessment> cases = assessments_of(campaign);
    const std::vector<ProblemAssessment> problems = problems_of(campaign);
    for (const char* form : {"", "-quick"}) {
      const fs::path ledger = verification / "baselines" / (campaign.name + form + ".jsonl");
      const Baseline baseline = baseline_of(read_ledger(ledger));
      rows += baseline.size();
      for (const RowMovement& one : movements(baseline, {cases, problems}))
        EXPECT_FALSE(one.lost()) << ledger.filename() << ": " << one.row;
    }
  }
  EXPECT_GT(rows, 500U);
}

}  // namespace
}  // namespace slosh::shipped_ledgers_test
