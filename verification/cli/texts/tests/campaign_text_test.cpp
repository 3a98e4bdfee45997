#include "verification/cli/texts/campaign_text.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace slosh::campaign_text_test {
namespace {

const std::string lines =
    "pass           small particles forced amplitude_error elevation@right: 1.23 % +- 1.4 % <= 30 "
    "%\n"
    "violated       small mesh forced amplitude_error elevation@right: 40 % is not <= 30 %\n"
    "FAIL: 1 of 2 gate rows hold, 1 violated.\n";

TEST(VerdictText, BreaksBetweenWordsAtTheTerminalsWidth) {
  for (const int columns : {40, 60, 80, 200}) {
    const std::string shown = as_shown(lines, {.live = true, .colour = false, .columns = columns});
    std::istringstream all(lines), broken(shown);
    for (std::string line; std::getline(broken, line);)
      EXPECT_LE(line.size(), static_cast<std::size_t>(columns)) << shown;
    broken = std::istringstream(shown);
    for (std::string expected, word; all >> expected;) {
      broken >> word;
      EXPECT_EQ(word, expected) << "a word was broken or lost at " << columns;
    }
  }
  EXPECT_EQ(as_shown(lines, {.live = false, .colour = false, .columns = 80}), lines);
  EXPECT_EQ(as_shown("report: /a/path/that/is/longer/than/the/terminal end\n",
                     {.live = true, .colour = false, .columns = 20}),
            "report:\n  /a/path/that/is/longer/than/the/terminal\n  end\n");
}

TEST(VerdictText, ColoursTheVerdictThatALineBeginsWith) {
  const DisplayStyle colours{.live = true, .colour = true, .columns = 80};
  for (const auto& [line, shown] : std::vector<std::pair<std::string, std::string>>{
           {"pass           a", "\033[32mpass\033[0m           a"},
           {"PASS: 1 of 1", "\033[32mPASS\033[0m: 1 of 1"},
           {"violated       a", "\033[31mviolated\033[0m       a"},
           {"solver failed  a", "\033[31msolver failed\033[0m  a"},
           {"FAIL: 0 of 1", "\033[31mFAIL\033[0m: 0 of 1"},
           {"inconclusive   a", "\033[33minconclusive\033[0m   a"},
           {"INCONCLUSIVE: 0", "\033[33mINCONCLUSIVE\033[0m: 0"},
           {"not compared   a", "\033[33mnot compared\033[0m   a"},
           {"validated              a", "\033[32mvalidated\033[0m              a"},
           {"watched, not validated a", "\033[34mwatched, not validated\033[0m a"},
           {"WATCHED, NOT VALIDATED: 0", "\033[34mWATCHED, NOT VALIDATED\033[0m: 0"},
           {"NOT COMPARED: 0", "\033[33mNOT COMPARED\033[0m: 0"},
           {"passage of time", "passage of time"},
           {"report: PASS", "report: PASS"}})
    EXPECT_EQ(as_shown(line + "\n", colours), shown + "\n");
  EXPECT_EQ(as_shown("PASS: 1\n", {.live = true, .colour = false, .columns = 80}), "PASS: 1\n");
}

}  // namespace
}  // namespace slosh::campaign_text_test
