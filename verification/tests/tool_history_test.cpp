// What a campaign's report tells of the campaign's earlier runs: the earlier result over the
// present one where a row does not hold.
#include <gtest/gtest.h>

#include "verification/files/content_hash.hpp"
#include "verification/results/result_file.hpp"
#include "verification/tests/small_campaign.hpp"

namespace slosh::tool_history_test {
namespace {

namespace fs = std::filesystem;

class ToolHistory : public SmallCampaign {
 protected:
  ToolHistory() { write_campaign(particles_case); }

  fs::path history() const { return store() / "history/surges.jsonl"; }
  Ended report_again() const { return tool({"report", "./surges.toml", "--output", "out"}); }

  // Moves the present result, and what the history says of it, to another build; the present build
  // has the result with its elevation scaled instead.
  void let_another_build_have_made_it_and_scale(double factor) const {
    const fs::path file = fs::canonical(result("particles"));
    const std::string answer = file.stem().string(), other(32, '0');
    RunResult present = read_result(file);
    RunResult earlier = present;
    earlier.key = with(present.key, answer, other);
    write_result(earlier, file.parent_path() / (other + ".h5"));
    write("out/store/history/surges.jsonl", with(read_bytes(history()), answer, other));
    for (TimeSeries& series : present.series)
      if (series.name == "elevation@right")
        for (double& value : series.value) value *= factor;
    write_result(present, file);
  }
};

TEST_F(ToolHistory, HasALineForEachStateOfTheCampaign) {
  ASSERT_EQ(campaign().status, 0);
  const std::string once = read_bytes(history());
  EXPECT_TRUE(holds(once, "\"small: particles against theory, forced amplitude_error of "));
  ASSERT_EQ(tool({"campaign", "./surges.toml", "--output", "elsewhere"}).status, 0);
  EXPECT_EQ(read_bytes(history()), once) << "the same state was entered twice";
}

TEST_F(ToolHistory, ShowsTheEarlierResultWhereARowDoesNotHoldAnyMore) {
  ASSERT_EQ(campaign().status, 0);
  let_another_build_have_made_it_and_scale(1.8);
  const Ended judged = report_again();
  EXPECT_EQ(judged.status, 1) << judged.out << judged.err;
  EXPECT_TRUE(fs::exists(report() / "figures/small-earlier-particles-elevation-right.svg"));
  EXPECT_TRUE(holds(report_words(), "it held."));
}

TEST_F(ToolHistory, ShowsNoEarlierResultThatTheStoreHasLost) {
  ASSERT_EQ(campaign().status, 0);
  let_another_build_have_made_it_and_scale(1.8);
  fs::remove(fs::canonical(result("particles")).parent_path() / (std::string(32, '0') + ".h5"));
  EXPECT_EQ(report_again().status, 1);
  EXPECT_FALSE(fs::exists(report() / "figures/small-earlier-particles-elevation-right.svg"));
}

TEST_F(ToolHistory, LeavesTheEarlierRunsOutWhereItsFileIsDamaged) {
  ASSERT_EQ(campaign().status, 0);
  write("out/store/history/surges.jsonl", "{");
  const Ended judged = tool({"campaign", "./surges.toml", "--output", "elsewhere"});
  EXPECT_EQ(judged.status, 0);
  EXPECT_TRUE(holds(judged.err, "surges.jsonl:1: not a line of a campaign's history"));
  EXPECT_TRUE(holds(judged.err, "Remove the file to begin a new history."));
}

TEST_F(ToolHistory, IsNotKeptOfAPartOfTheCampaign) {
  ASSERT_EQ(
      tool({"campaign", "./surges.toml", "--output", "out", "--only", "small/particles"}).status,
      0);
  EXPECT_FALSE(fs::exists(history()));
}

}  // namespace
}  // namespace slosh::tool_history_test
