// The list of problems, and the shipped campaigns over them.
#include <gtest/gtest.h>

#include <set>

#include "verification/case_file/campaign_parser.hpp"
#include "verification/problems/problem_list.hpp"

namespace slosh::problem_test {
namespace {

// Of both campaigns that have problems.
std::vector<ProblemDefinition> shipped() {
  const std::filesystem::path verification =
      std::filesystem::path(SLOSH_SOURCE_DIR) / "verification";
  std::vector<ProblemDefinition> problems;
  for (const char* name : {"campaigns/verification.toml", "campaigns/stability.toml"}) {
    const CampaignDefinition campaign =
        read_campaign(verification / name, verification / "cases", known_problems());
    problems.insert(problems.end(), campaign.problems.begin(), campaign.problems.end());
  }
  return problems;
}

TEST(Problems, HaveNamesOfTheirOwnAndMeasuresOfTheirOwn) {
  std::set<std::string> names;
  for (const Problem& problem : all_problems()) {
    EXPECT_TRUE(names.insert(problem.name).second) << problem.name;
    std::set<std::string> measures;
    for (const MeasureKind& kind : problem.measures)
      EXPECT_TRUE(measures.insert(kind.name).second) << kind.name;
    EXPECT_FALSE(measures.empty()) << problem.name;
  }
  EXPECT_EQ(find_problem("taylor_green").name, "taylor_green");
}

TEST(Problems, AreSuggestedWhereANameIsWrong) {
  try {
    find_problem("taylor_gren");
    FAIL() << "found a problem that is not there";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("nearest: taylor_green"), std::string::npos)
        << error.what();
  }
}

TEST(ShippedCampaigns, GateEveryProblemOnceAndEveryGateRowHasASource) {
  std::set<std::string> names;
  for (const ProblemDefinition& problem : shipped()) EXPECT_TRUE(names.insert(problem.name).second);
  EXPECT_EQ(names.size(), all_problems().size());
  for (const ProblemDefinition& problem : shipped())
    for (const ProblemGateRow& row : problem.gate) EXPECT_GT(row.source.size(), 8u);
}

}  // namespace
}  // namespace slosh::problem_test
