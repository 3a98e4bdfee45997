// What --help promises: examples that run, exit statuses that docs/commands.md has too, names that
// are nearest to a wrong one.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "verification/gate/gate.hpp"
#include "verification/tests/small_campaign.hpp"

namespace slosh::tool_help_test {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

class ToolHelp : public SmallCampaign {
 protected:
  // The --help of the command and of all below it.
  void collect(const std::vector<std::string>& command, std::vector<std::string>& helps) const {
    std::vector<std::string> asking = command;
    asking.push_back("--help");
    const Ended help = tool(asking);
    EXPECT_EQ(help.status, 0) << ::testing::PrintToString(asking);
    EXPECT_EQ(help.err, "");
    helps.push_back(help.out);
    bool listing = false;
    for (const std::string& line : lines_of(help.out)) {
      if (listing && line.empty()) break;
      if (listing) {
        std::vector<std::string> below = command;
        below.push_back(line.substr(2, line.find(' ', 2) - 2));
        collect(below, helps);
      }
      listing |= line == "Subcommands:";
    }
  }
};

TEST_F(ToolHelp, ShowsFiveLinesToBeginWithWhereNothingIsAsked) {
  const Ended alone = tool({});
  EXPECT_EQ(alone.status, exit_usage);
  const std::vector<std::string> shown = lines_of(alone.out);
  ASSERT_EQ(shown.size(), 5u);
  for (const std::string& line : shown) EXPECT_TRUE(line.starts_with("./slosh ")) << line;
  EXPECT_TRUE(holds(shown[0], "new my_tank --minimal"));
}

TEST_F(ToolHelp, GivesEveryCommandExamplesThatRun) {
  write("slosh", "#!/bin/sh\nexec '" SLOSH_TOOL "' \"$@\"\n");
  std::filesystem::permissions(directory() / "slosh", std::filesystem::perms::owner_all);
  std::vector<std::string> helps;
  collect({}, helps);
  EXPECT_GT(helps.size(), 12u);
  for (const std::string& help : helps) {
    int examples = 0;
    for (const std::string& line : lines_of(help)) {
      const bool is_of_shell = line.starts_with("  printf ");
      if (!line.starts_with("  ./slosh ") && !is_of_shell) continue;
      examples += !is_of_shell;
      const Ended run = end_of(start("/bin/sh", {"-c", line}));
      // A baseline that is not there yet has changed; everything else succeeds.
      EXPECT_EQ(run.status, line.find("baseline diff") == line.npos ? exit_pass : exit_violated)
          << line << "\n"
          << run.out << run.err;
    }
    const bool has_commands = help.find("Subcommands:") != help.npos;
    EXPECT_TRUE(examples > 0 || has_commands) << help;
  }
}

TEST_F(ToolHelp, TellsTheExitStatusesAsTheDocumentsDo) {
  const std::string help = tool({"--help"}).out;
  std::ifstream stream(SLOSH_SOURCE_DIR "/docs/commands.md");
  const std::string page{std::istreambuf_iterator<char>(stream), {}};
  std::string table = "| exit status | meaning |\n|---|---|\n";
  std::set<int> statuses;
  for (const auto& [status, meaning] : exit_meanings) {
    std::ostringstream line;
    line << "  " << std::setw(3) << status << "  " << meaning << "\n";
    EXPECT_TRUE(holds(help, line.str()));
    table += "| " + std::to_string(status) + " | " + meaning + " |\n";
    EXPECT_TRUE(statuses.insert(status).second) << status << " has two meanings";
  }
  EXPECT_TRUE(holds(page, table + "\n"));
}

TEST_F(ToolHelp, NamesTheCommandsOfTheLauncher) {
  const std::string help = tool({"--help"}).out;
  for (const char* name : {"  test ", "  bench ", "  doctor "}) EXPECT_TRUE(holds(help, name));
}

TEST_F(ToolHelp, BeginsItsAnswerToAWrongWordWithTheNearestOnes) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong{
      {{"report", "x"}, "command 'report' is not known; use `./slosh campaign NAME --report-only`"},
      {{"selftest", "x"}, "command 'selftest' is not known; use `./slosh gate NAME --selftest`"},
      {{"problem", "x"}, "command 'problem' is not known; use `./slosh run PROBLEM`"},
      {{"check", "x"}, "command 'check' is not known; use `./slosh explain CASE`"},
      {{"campain"}, "command 'campain' is not known; did you mean 'campaign'"},
      {{"baseline", "aprove", "x"}, "command 'aprove' is not known; did you mean 'approve'"},
      {{"gate", "small_amplitude", "--qick"},
       "option '--qick' is not known; did you mean '--quick'"},
      {{"--versoin"}, "option '--versoin' is not known; did you mean '--version'"}};
  for (const auto& [arguments, message] : wrong) {
    const Ended run = tool(arguments);
    EXPECT_EQ(run.status, exit_usage);
    EXPECT_TRUE(run.err.starts_with(message)) << run.err;
    EXPECT_EQ(run.err.find("is required"), std::string::npos) << run.err;
  }
}

TEST_F(ToolHelp, GivesHelpBesideAWrongWordWhereItIsAskedFor) {
  const Ended run = tool({"campain", "--help"});
  EXPECT_EQ(run.status, 0);
  EXPECT_TRUE(holds(run.out, "Usage: "));
}

TEST_F(ToolHelp, ShowsTheToolAsItIsStarted) {
  EXPECT_TRUE(holds(tool({"--help"}).out, "\nUsage: ./slosh [OPTIONS] SUBCOMMAND\n"));
  EXPECT_TRUE(holds(tool({"run", "--help"}).out, "\nUsage: ./slosh run [OPTIONS] "));
  EXPECT_TRUE(holds(tool({"baseline", "approve", "--help"}).out,
                    "\nUsage: ./slosh baseline approve [OPTIONS] "));
}

TEST_F(ToolHelp, TellsItsVersion) {
  EXPECT_EQ(tool({"--version"}).out, "Slosh " SLOSH_VERSION "\n");
}

}  // namespace
}  // namespace slosh::tool_help_test
