// Completion as bash asks for it: the script is sourced, and its function called with the words of
// a command line that is being typed.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "verification/tests/small_campaign.hpp"

namespace slosh::tool_completion_test {
namespace {

using Words = std::vector<std::string>;

class ToolCompletion : public SmallCampaign {
 protected:
  Words completed(const Words& words) const {
    std::string script = "source ./completion.bash || exit 1\nCOMP_WORDS=(slosh";
    for (const std::string& word : words) script += " '" + word + "'";
    script += ")\nCOMP_CWORD=" + std::to_string(words.size()) +
              "\n_slosh || exit 1\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n";
    write("completion.bash", tool({"completion", "bash"}).out);
    write("ask.bash", script);
    const Ended asked = end_of(start("/bin/bash", {"ask.bash"}));
    EXPECT_EQ(asked.status, 0) << asked.err;
    EXPECT_EQ(asked.err, "");
    Words found;
    std::istringstream stream(asked.out);
    for (std::string word; stream >> word;) found.push_back(word);
    return found;
  }
};

bool has(const Words& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

TEST_F(ToolCompletion, CompletesCommandsThoseOfTheLauncherToo) {
  const Words all = completed({""});
  for (const char* name : {"campaign", "gate", "baseline", "explain", "converge", "doctor"})
    EXPECT_TRUE(has(all, name)) << name;
  EXPECT_FALSE(has(all, "complete")) << "a command that only the scripts call";
  EXPECT_EQ(completed({"camp"}), Words{"campaign"});
  EXPECT_EQ(completed({"baseline", "ap"}), Words{"approve"});
  EXPECT_EQ(completed({"no_such", "thing", ""}), Words{});
}

TEST_F(ToolCompletion, CompletesOptionsOfTheCommand) {
  EXPECT_EQ(completed({"campaign", "small_amplitude", "--qu"}), Words{"--quick"});
  EXPECT_TRUE(has(completed({"run", "--"}), "--snapshots"));
  EXPECT_FALSE(has(completed({"run", "--"}), "--quick"));
}

TEST_F(ToolCompletion, CompletesNamesOfCampaignsCasesRunsProblemsAndTags) {
  EXPECT_EQ(completed({"gate", "small_a"}), Words{"small_amplitude"});
  EXPECT_EQ(completed({"gate", "--quick", "-j", "2", "small_a"}), Words{"small_amplitude"});
  EXPECT_EQ(completed({"explain", "li2010_large_b0"}), Words{"li2010_large_b075"});
  EXPECT_EQ(completed({"run", "li2010_small_amplitude", "linear_t"}), Words{"linear_two_layer"});
  EXPECT_EQ(completed({"problem", "taylor"}), Words{"taylor_green"});
  EXPECT_EQ(completed({"list", "--tag", "small_"}), Words{"small_amplitude"});
  EXPECT_EQ(completed({"campaign", "li2010", "--only", "li2010_small_amplitude/linear_"}),
            Words{"li2010_small_amplitude/linear_two_layer"});
  EXPECT_EQ(completed({"list", "--names", "pro"}), Words{"problems"});
  EXPECT_EQ(completed({"completion", "z"}), Words{"zsh"});
}

TEST_F(ToolCompletion, LeavesFilesAndNumbersToTheShell) {
  EXPECT_EQ(completed({"campaign", "small_amplitude", "-o", ""}), Words{});
  EXPECT_EQ(completed({"campaign", "small_amplitude", "--jobs", ""}), Words{});
  EXPECT_EQ(completed({"run", "no_such_case", ""}), Words{});
}

TEST_F(ToolCompletion, PrintsScriptsThatTheirShellsRead) {
  for (const char* shell : {"bash", "zsh", "fish"}) {
    const Ended printed = tool({"completion", shell});
    EXPECT_EQ(printed.status, 0);
    const std::string found = boost::process::search_path(shell).string();
    if (found.empty()) continue;  // fish and zsh are not everywhere
    write("script", printed.out);
    EXPECT_EQ(end_of(start(found, {"-n", "script"})).status, 0) << shell;
  }
  EXPECT_EQ(tool({"completion", "tcsh"}).status, 2);
}

}  // namespace
}  // namespace slosh::tool_completion_test
