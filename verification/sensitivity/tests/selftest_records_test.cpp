// The records of the shipped campaigns' self-tests (case_coverage.hpp): each form of each
// campaign has one, of the rows as they are, which shows that the rows of every case detect
// together what every case must detect.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "verification/case_file/campaign_parser.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/problems/problem_list.hpp"
#include "verification/sensitivity/case_coverage.hpp"

namespace slosh::selftest_records_test {
namespace {

namespace fs = std::filesystem;

const fs::path verification = fs::path(SLOSH_SOURCE_DIR) / "verification";

// The cases of a campaign of which the form runs something.
std::vector<CaseDefinition> cases_of(const CampaignDefinition& campaign, bool quick) {
  std::vector<CaseDefinition> cases;
  for (const fs::path& file : campaign.cases) {
    CaseDefinition one = read_case(file, {});
    if (!quick || std::ranges::any_of(one.runs, &RunDefinition::quick))
      cases.push_back(std::move(one));
  }
  return cases;
}

class SelftestRecords : public ::testing::TestWithParam<fs::path> {
 protected:
  void expect_to_hold(bool quick) const {
    const CampaignDefinition campaign =
        read_campaign(GetParam(), verification / "cases", known_problems());
    if (campaign.cases.empty()) return;
    const fs::path file = selftest_record_file(verification / "baselines", campaign.name, quick);
    ASSERT_TRUE(fs::exists(file)) << "no self-test of this form is recorded; ./slosh gate "
                                  << campaign.name << (quick ? " --quick" : "")
                                  << " --selftest --record makes it";
    try {
      const SelftestRecord record = read_selftest_record(file);
      EXPECT_EQ(record.campaign, campaign.name);
      EXPECT_EQ(record.quick, quick);
      for (const std::string& one : shortcomings(record, cases_of(campaign, quick)))
        ADD_FAILURE() << file.filename().string() << ": " << one;
    } catch (const SelftestRecordError& error) {
      ADD_FAILURE() << error.what();
    }
  }
};

TEST_P(SelftestRecords, OfTheQuickFormShowThatEachCaseDetectsWhatItMust) { expect_to_hold(true); }

TEST_P(SelftestRecords, OfTheWholeFormShowThatEachCaseDetectsWhatItMust) { expect_to_hold(false); }

std::vector<fs::path> shipped_campaigns() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(verification / "campaigns"))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  return files;
}

INSTANTIATE_TEST_SUITE_P(Shipped, SelftestRecords, ::testing::ValuesIn(shipped_campaigns()),
                         [](const auto& info) { return info.param.stem().string(); });

}  // namespace
}  // namespace slosh::selftest_records_test
