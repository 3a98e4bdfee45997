// What the store shares: a result of `slosh run` with campaigns, and the room of old ones.
#include <gtest/gtest.h>

#include "verification/results/result_file.hpp"
#include "verification/tests/small_campaign.hpp"

namespace slosh::tool_store_test {
namespace {

namespace fs = std::filesystem;

class ToolStore : public SmallCampaign {
 protected:
  ToolStore() { write_campaign(particles_case); }

  // Makes a result of the store that of a build that is none of this tree's.
  static fs::path made_old(const fs::path& file) {
    const std::string answer(32, '0');
    RunResult result = read_result(file);
    result.key = file.parent_path().filename().string() + "-" + answer;
    const fs::path old = file.parent_path() / (answer + ".h5");
    write_result(result, old);
    fs::remove(file);
    return old;
  }
};

TEST_F(ToolStore, GivesACampaignWhatARunLeftInAFile) {
  const Ended made = run("particles", {"-o", "mine.h5"});
  ASSERT_EQ(made.status, 0) << made.err;
  const Ended judged = campaign();
  EXPECT_EQ(judged.status, 0) << judged.err;
  EXPECT_FALSE(holds(judged.err, "finished small/particles")) << "it was computed again";
  EXPECT_TRUE(holds(judged.err, "finished small/theory"));
  EXPECT_EQ(read_result(result("particles")).provenance,
            read_result(directory() / "mine.h5").provenance);
}

TEST_F(ToolStore, TakesNoResultOfARunThatSavedItsState) {
  ASSERT_EQ(run("particles", {"--states", "4"}).status, 0);
  EXPECT_TRUE(files_of_store(".h5").empty());
}

TEST_F(ToolStore, FailsNoRunWhereNothingCanBeKeptForCampaigns) {
  write("no_directory", "");
  const Ended made = tool({"run", "./small.toml", "theory"}, {{"SLOSH_STORE", "no_directory/s"}});
  EXPECT_EQ(made.status, 0);
  EXPECT_TRUE(holds(made.err, "no campaign can take the result: "));
  EXPECT_TRUE(fs::exists(directory() / "theory.h5"));
}

TEST_F(ToolStore, TellsAndRemovesWhatEarlierBuildsLeftAndNothingElse) {
  ASSERT_EQ(run("theory").status, 0);
  ASSERT_EQ(files_of_store(".h5").size(), 1u);
  const fs::path old = made_old(files_of_store(".h5").front());
  ASSERT_EQ(run("theory").status, 0);

  const Ended told = tool({"store"});
  EXPECT_EQ(told.status, 0);
  EXPECT_TRUE(holds(told.out, "small/theory (linear), "));
  EXPECT_TRUE(holds(told.out, ": 2 results, "));
  EXPECT_TRUE(holds(told.out, "; 1 of them, "));
  EXPECT_TRUE(fs::exists(old)) << "what only tells removes nothing";
  const Ended total = tool({"store", "--total"});
  EXPECT_FALSE(holds(total.out, "small/theory"));
  EXPECT_TRUE(told.out.ends_with(total.out));

  const Ended removed = tool({"store", "--remove"});
  EXPECT_EQ(removed.status, 0);
  EXPECT_TRUE(holds(removed.out, "removed "));
  EXPECT_TRUE(holds(removed.out, ": 1 results removed, "));
  EXPECT_FALSE(fs::exists(old));
  EXPECT_EQ(files_of_store(".h5").size(), 1u);
  EXPECT_TRUE(holds(tool({"store"}).out, "; 0 of them, 0.0 kB, are of earlier builds\n"));
}

TEST_F(ToolStore, KeepsWhatOnlyLooksLikeAResultAndSaysSo) {
  const fs::path question = store() / std::string(32, 'a');
  const std::string answer(32, '0');
  fs::create_directories(question / (answer + ".work"));
  for (const char* file :
       {".h5", ".json", ".timings.json", ".notes.txt", ".work/notes.txt", ".\x1b[31mred"})
    std::ofstream(question / (answer + file)) << "a week of work";
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"store"}, {"store", "--remove"}}) {
    const Ended ended = tool(words);
    EXPECT_EQ(ended.status, 0) << ended.err;
    for (const char* file : {".work", ".h5", ".json", ".timings.json", ".notes.txt"}) {
      EXPECT_TRUE(holds(ended.out, "kept       " + (question / (answer + file)).string() + ", "));
      EXPECT_TRUE(fs::exists(question / (answer + file)));
    }
    EXPECT_TRUE(holds(ended.out, answer + ".red, "));
    EXPECT_FALSE(holds(ended.out, "\x1b"));
    EXPECT_FALSE(holds(ended.out, "removed  "));
  }
}

}  // namespace
}  // namespace slosh::tool_store_test
