// The tool as a user sees it on a terminal, here a pseudo-terminal of 80 columns.
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <sstream>

#include "verification/tests/small_campaign.hpp"

namespace slosh::tool_terminal_test {
namespace {

constexpr unsigned short columns = 80;

struct Shown {
  int status;        // as of Ended
  std::string text;  // output and errors as the terminal got them, its line ends as "\n"
};

class ToolTerminal : public SmallCampaign {
 protected:
  Shown shown(const std::vector<std::string>& arguments, const Environment& more = {}) const {
    const winsize size{.ws_row = 40, .ws_col = columns, .ws_xpixel = 0, .ws_ypixel = 0};
    int terminal = -1;
    const pid_t tool = forkpty(&terminal, nullptr, nullptr, &size);
    if (tool == 0) become_tool(arguments, more);
    std::string text;
    std::array<char, 4096> part{};
    for (ssize_t got = 0; (got = ::read(terminal, part.data(), part.size())) > 0;)
      text.append(part.data(), static_cast<std::size_t>(got));
    close(terminal);
    int status = 0;
    waitpid(tool, &status, 0);
    std::erase(text, '\r');
    return {WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status), text};
  }

 private:
  [[noreturn]] void become_tool(const std::vector<std::string>& arguments,
                                const Environment& more) const {
    if (chdir(directory().c_str()) != 0) _exit(99);
    Environment all{{"TERM", "xterm"}, {"OMP_NUM_THREADS", "1"}, {"SLOSH_STORE", store()}};
    unsetenv("NO_COLOR");
    unsetenv("SLOSH_EXPERIMENTS");
    for (const auto& [name, value] : more) all[name] = value;
    for (const auto& [name, value] : all) setenv(name.c_str(), value.c_str(), 1);
    std::vector<std::string> words{SLOSH_TOOL};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    execv(SLOSH_TOOL, argv.data());
    _exit(99);
  }
};

std::string without_colours(std::string text) {
  for (const char* code : {"\033[31m", "\033[32m", "\033[33m", "\033[0m"})
    for (std::size_t at = 0; (at = text.find(code)) != std::string::npos;)
      text.erase(at, std::string(code).size());
  return text;
}

TEST_F(ToolTerminal, ColoursTheVerdictsOfACampaignUnlessNoColorIsSet) {
  write_campaign(particles_case);
  const std::vector<std::string> arguments{"campaign", "./surges.toml", "--output", "out"};
  const Shown first = shown(arguments);
  EXPECT_EQ(first.status, 0) << first.text;
  EXPECT_TRUE(
      holds(first.text, "\033[32mPASS\033[0m: SPH at 25 mm against linear theory: amplitude"));
  EXPECT_TRUE(holds(first.text, "\033[32mpass\033[0m           small particles forced"));
  EXPECT_TRUE(holds(shown(arguments).text,
                    "\033[32mPASS\033[0m: SPH at 25 mm against linear theory: amplitude"))
      << "where the verdict is said again";
  const Shown plain = shown(arguments, {{"NO_COLOR", "1"}});
  EXPECT_TRUE(holds(plain.text, "1 of 1 gate rows"));
  EXPECT_EQ(plain.text.find("\033["), std::string::npos);
  EXPECT_EQ(tool(arguments).out.find('\033'), std::string::npos) << "it is no terminal";
}

TEST_F(ToolTerminal, BreaksTheLinesOfVerdictsBetweenWords) {
  write_campaign(particles_case);
  const std::vector<std::string> arguments{"campaign", "./surges.toml", "--output", "out"};
  shown(arguments);
  const std::string again = shown(arguments, {{"NO_COLOR", "1"}}).text, whole = tool(arguments).out;
  EXPECT_GT(std::count(again.begin(), again.end(), '\n'),
            std::count(whole.begin(), whole.end(), '\n'));
  std::istringstream lines(again), words(again), expected(whole);
  for (std::string line; std::getline(lines, line);)
    EXPECT_TRUE(line.size() <= columns || line.find(' ', 4) == std::string::npos) << line;
  for (std::string word, other; expected >> word;) {
    words >> other;
    EXPECT_EQ(other, word);
  }
}

TEST_F(ToolTerminal, ShowsACampaignsRunsAndItsTimeLeftWithinTheTerminal) {
  write_campaign(with(particles_case, "duration_s = 8.0", "duration_s = 40.0"));
  const Shown campaign = shown({"campaign", "./surges.toml", "--output", "out"});
  EXPECT_EQ(campaign.status, 0) << campaign.text;
  EXPECT_TRUE(holds(campaign.text, "running  small/particles"));
  EXPECT_TRUE(holds(campaign.text, "[1/2] "));
  EXPECT_TRUE(holds(campaign.text, " left\n"));
  std::istringstream lines(without_colours(campaign.text));
  for (std::string line; std::getline(lines, line);) {
    const std::size_t begin = line.rfind("\033[2K");
    const std::string seen = begin == std::string::npos ? line : line.substr(begin + 4);
    EXPECT_TRUE(seen.size() <= columns || seen.find("/") != std::string::npos) << seen;
  }
}

TEST_F(ToolTerminal, ShowsTheProgressOfASingleRunAndTakesItAway) {
  write_campaign(with(particles_case, "duration_s = 8.0", "duration_s = 40.0"));
  const Shown run = shown({"run", "./small.toml", "particles"});
  EXPECT_EQ(run.status, 0) << run.text;
  EXPECT_TRUE(holds(run.text, "running  small/particles  "));
  EXPECT_TRUE(holds(run.text, " simulated s per s, "));
  EXPECT_TRUE(holds(run.text, "\033[1A\033[2Kelevation@right: highest "));
  EXPECT_EQ(run.text.find("[0/1]"), std::string::npos) << "it is no campaign";
}

TEST_F(ToolTerminal, EndsASingleRunWithItsSummary) {
  write_campaign(particles_case);
  const Ended run = tool({"run", "./small.toml", "particles"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err, "") << "progress outside a terminal";
  for (const char* part : {"elevation@right: highest ", ", lowest ", ", period ",
                           " s (spectral peak)\ncost: ", " core-seconds in ", " of wall time, ",
                           " particles\nsteps: ", " ms each: landing on the samples every 10 ms ",
                           "\nresult: particles.h5\n"})
    EXPECT_TRUE(holds(run.out, part));
}

}  // namespace
}  // namespace slosh::tool_terminal_test
