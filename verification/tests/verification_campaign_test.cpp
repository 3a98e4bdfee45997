// The shipped suite of problems through the tool, in its quick form: it holds, a second start
// computes nothing, and what is wrong with a problem or its result is told.
#include <gtest/gtest.h>

#include "verification/tests/small_campaign.hpp"

namespace slosh::verification_campaign_test {
namespace {

namespace fs = std::filesystem;

class VerificationCampaign : public SmallCampaign {};

// The shipped campaign without its cases, which take minutes.
std::string shipped_problems() {
  std::ifstream stream(fs::path(SLOSH_SOURCE_DIR) / "verification/campaigns/verification.toml");
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  const std::size_t cases = text.find("cases = [");
  return text.erase(cases, text.find("]\n", cases) + 2 - cases);
}

// Half a minute: the shipped problems themselves, each once, which no other test runs as a
// campaign.
TEST_F(VerificationCampaign, HoldsInItsQuickFormAndComputesNothingTwice) {
  write("problems.toml", shipped_problems());
  const std::vector<std::string> command{"campaign", "./problems.toml", "--quick", "--output",
                                         "out"};
  const Ended first = tool(command);
  EXPECT_EQ(first.status, 0) << first.err << first.out;
  EXPECT_NE(first.out.find("PASS: "), std::string::npos) << first.out;
  for (const char* part : {"problem-taylor_green", "problem-rigid_rotation"})
    EXPECT_NE(read(report() / "problems.html").find(part), std::string::npos) << part;
  EXPECT_NE(read(report() / "results.json").find("\"oscillating_drop\""), std::string::npos);
  const fs::path kept = directory() / "out/problems/taylor_green.json";
  const auto written = fs::last_write_time(kept);
  const Ended second = tool(command);
  EXPECT_EQ(second.status, 0) << second.err;
  EXPECT_EQ(second.err, "") << "a problem was started";
  EXPECT_EQ(fs::last_write_time(kept), written);
}

// Shipped cases that take seconds each, run and tested by the tool itself.
TEST_F(VerificationCampaign, DetectsTogetherWhatEveryCaseMust) {
  write("extremes.toml",
        "schema_version = 1\nname = \"extremes\"\ntitle = \"Extremes\"\nsource = \"a test\"\n"
        "cases = [\"extreme_zero_gravity\", \"extreme_impulsive_stop\", "
        "\"extreme_million_particles\"]\n");
  const Ended run = tool({"campaign", "./extremes.toml", "--quick", "--output", "out"});
  ASSERT_EQ(run.status, 0) << run.err << run.out;
  const Ended tested =
      tool({"gate", "--selftest", "./extremes.toml", "--quick", "--output", "out"});
  EXPECT_EQ(tested.status, 0) << tested.out;
  EXPECT_NE(tested.out.find("the rows of 0 of 3 cases miss"), std::string::npos) << tested.out;
}

const std::string small_suite = R"(schema_version = 1
name = "suite"
title = "One problem"
source = "made for a test"
[[problem]]
name = "gamma_map"
[[problem.gate]]
measure = "limit"
metric = "largest_error"
unit = "1"
limit = 0.1
reason = "a reason"
source = "a source"
)";

TEST_F(VerificationCampaign, EndsWithOneWhereALimitIsViolated) {
  write("suite.toml", with(small_suite, "limit = 0.1", "limit = 1e-3"));
  const Ended run = tool({"campaign", "./suite.toml", "--output", "out"});
  EXPECT_EQ(run.status, 1) << run.err;
  EXPECT_NE(run.out.find("violated       gamma_map largest_error limit"), std::string::npos)
      << run.out;
  EXPECT_NE(run.out.find("0 of 1 gate rows hold, 1 violated."), std::string::npos);
}

TEST_F(VerificationCampaign, NeverPassesATruncatedResultAndComputesItAgain) {
  write("suite.toml", small_suite);
  ASSERT_EQ(tool({"campaign", "./suite.toml", "--output", "out"}).status, 0);
  const fs::path result = directory() / "out/problems/gamma_map.json";
  fs::resize_file(result, fs::file_size(result) / 2);
  EXPECT_EQ(tool({"campaign", "--report-only", "./suite.toml", "--output", "out"}).status, 4);
  const Ended again = tool({"campaign", "./suite.toml", "--output", "out"});
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_NE(again.err.find("it is computed again"), std::string::npos) << again.err;
}

TEST_F(VerificationCampaign, NamesTheNearestProblemOfAWrongName) {
  const Ended one = tool({"run", "gama_map"});
  EXPECT_EQ(one.status, 2);
  EXPECT_NE(one.err.find("nearest: gamma_map"), std::string::npos) << one.err;
  write("suite.toml", with(small_suite, "\"gamma_map\"", "\"gama_map\""));
  const Ended all = tool({"campaign", "./suite.toml"});
  EXPECT_EQ(all.status, 2);
  EXPECT_NE(all.err.find("suite.toml:6: problem.name = \"gama_map\": expected a problem, one of "),
            std::string::npos)
      << all.err;
}

}  // namespace
}  // namespace slosh::verification_campaign_test
