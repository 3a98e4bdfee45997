// A new case that is made from another one can be read, and its keys are explained.
#include "verification/case_file/from_keys/commented_case.hpp"

#include <gtest/gtest.h>

#include "verification/case_file/key_table.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::commented_case_test {
namespace {

const std::filesystem::path cases = SLOSH_SOURCE_DIR "/verification/cases";

CaseDefinition shipped(const std::string& name) { return read_case(cases / (name + ".toml")); }

TEST(CommentedCase, CanBeReadWhateverShippedCaseItIsLike) {
  const Workspace workspace;
  int made = 0;
  for (const auto& entry : std::filesystem::directory_iterator(cases)) {
    if (entry.path().extension() != ".toml") continue;
    const CaseDefinition like = read_case(entry.path());
    const std::filesystem::path file = workspace.write("new.toml", commented_case(like, "my_tank"));
    ASSERT_EQ(complaint(file), "") << entry.path();
    const CaseDefinition read = read_case(file);
    EXPECT_EQ(read.name, "my_tank");
    EXPECT_EQ(read.tank.length, like.tank.length);
    EXPECT_EQ(read.gauges.size(), like.gauges.size());
    EXPECT_GE(read.runs.size(), 1u);
    ++made;
  }
  EXPECT_GE(made, 30);
}

TEST(CommentedCase, KeepsTheTheoriesAndTheCoarsestJudgedRunWithItsRows) {
  const Workspace workspace;
  const CaseDefinition read = read_case(
      workspace.write("new.toml", commented_case(shipped("li2010_small_amplitude"), "my_tank")));
  std::vector<std::string> runs;
  for (const RunDefinition& run : read.runs) runs.push_back(run.name);
  EXPECT_EQ(runs, (std::vector<std::string>{"linear", "linear_two_layer", "recommended_10mm",
                                            "potential"}));
  for (const GateRow& row : read.gate) EXPECT_EQ(row.candidate, "recommended_10mm");
  EXPECT_GE(read.gate.size(), 1u);
}

// The shipped case has several spacings in one table, and its rows in groups.
TEST(CommentedCase, NarrowsTablesOfSeveralRunsAndGroupsOfRowsToTheKeptRun) {
  const std::string text = commented_case(shipped("li2010_small_amplitude"), "my_tank");
  for (const char* line : {"\nname = \"recommended_10mm\"\n", "\nparticle_spacing_m = 0.01\n",
                           "\nquick = true\n", "\ncandidate = \"recommended_10mm\"\n"})
    EXPECT_TRUE(holds(text, line)) << line << "\nin\n" << text;
  EXPECT_FALSE(holds(text, "\ncandidates = "));
}

TEST(CommentedCase, ExplainsEachKeyOnceInTheWordsOfTheKeyTable) {
  const std::string text = commented_case(shipped("li2010_small_amplitude"), "my_tank");
  for (const char* line :
       {"# length_m: number > 0, m. The inner length.\nlength_m = 1.0\n",
        "# fill_depth_m: number > 0 and below the tank's height, m. The still depth.\n",
        "# Not here: breadth_m: number > 0, m. The inner breadth of a narrow tank",
        "# A tank, seen from the side: a rectangle, a polygon or a lying cylinder."})
    EXPECT_TRUE(holds(text, line)) << line << "\nin\n" << text;
  const std::string once = "# solver: text. The solver: one of the tables below.";
  EXPECT_EQ(text.find(once), text.rfind(once));
}

TEST(CommentedCase, RefusesANameThatNoCaseMayHave) {
  EXPECT_THROW(commented_case(shipped("still_water"), "my tank"), CaseFileError);
  EXPECT_THROW(commented_case(shipped("still_water"), ""), CaseFileError);
}

TEST(CommentedCase, RefusesACaseWithoutAnSphRun) {
  CaseDefinition like = shipped("still_water");
  like.runs.clear();
  EXPECT_THROW(commented_case(like, "my_tank"), CaseFileError);
}

}  // namespace
}  // namespace slosh::commented_case_test
