// What the store shares: a result of `slosh run` with campaigns, and the room of old ones.
#include <gtest/gtest.h>
#include <unistd.h>

#include <optional>

#include "verification/files/file_lock.hpp"
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

// At once and once, whether the other start holds the result or the output.
TEST_F(ToolStore, LetsACampaignSayWhatItWaitsFor) {
  ASSERT_EQ(campaign().status, 0);
  const fs::path kept = fs::canonical(result("theory")), out = directory() / "out";
  for (const auto& [lock, words] :
       {std::pair(fs::path(kept).replace_extension(".lock"),
                  std::string("small/theory: another start computes this result")),
        {out / "jobs/lock", "another start works in " + out.string()}}) {
    fs::remove(kept);
    auto held = std::make_optional<FileLock>(lock);
    auto gate = start_tool({"gate", "./surges.toml", "-o", "out"});
    const fs::path err = directory().parent_path() / "err";
    const std::string told = words + "; waiting for it\n";
    for (int i = 0; i < 1000 && read(err).find(told) == std::string::npos; ++i) ::usleep(10'000);
    ::usleep(500'000);
    EXPECT_EQ(read(err), told);
    held.reset();
    const Ended ended = end_of(std::move(gate));
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_TRUE(begins(ended.err, told));
    EXPECT_EQ(ended.err.find(told, 1), std::string::npos);
  }
}

// Of a tree whose paths are longer than the system allows, and of a file of holes.
TEST_F(ToolStore, NamesAndKeepsWhatCannotBeRead) {
  const fs::path question = store() / std::string(32, 'a'),
                 deep = question / (std::string(32, '0') + ".work"),
                 huge = question / (std::string(32, '1') + ".h5");
  fs::create_directories(deep);
  std::ofstream(huge) << "holes";
  fs::resize_file(huge, 2'000'000'000);
  const fs::path here = fs::current_path();
  fs::current_path(deep);
  for (int level = 0; level < 30; ++level) {
    fs::create_directory(std::string(200, 'd'));
    fs::current_path(std::string(200, 'd'));
  }
  fs::current_path(here);
  for (const char* words : {"store", "store --total", "store --remove"}) {
    const Ended ended = typed(words);
    EXPECT_EQ(ended.status, 0) << words << ended.err;
    for (const fs::path& kept : {deep, huge})
      EXPECT_EQ(ended.out.find("kept       " + kept.string()) == std::string::npos,
                words == std::string("store --total"));
  }
  EXPECT_TRUE(fs::exists(deep) && fs::exists(huge));
}

}  // namespace
}  // namespace slosh::tool_store_test
