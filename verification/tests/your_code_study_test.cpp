// The commands of docs/your_code.md that take the fine run: the whole campaign and the study of
// spacings.
#include <gtest/gtest.h>

#include <algorithm>

#include "verification/tests/page_commands.hpp"

namespace slosh::your_code_study_test {
namespace {

class YourCodeStudy : public PageCommands {};

TEST_F(YourCodeStudy, EndsWithTheReportAndTheOrderThatThePageShows) {
  const std::string text = page("your_code.md");
  const std::vector<std::string> shown = command_lines(text);
  std::string printed;
  for (const std::string line :
       {"cp -r docs/your_code ../my_sph", "g++ -O2 -o ../my_sph/small_sph ../my_sph/small_sph.cpp",
        "./slosh campaign ../my_sph/campaign.toml -o ../my_sph/whole",
        "./slosh converge ../my_sph/wave.toml --family small_sph --spacings 0.05,0.04,0.02 -o "
        "../my_sph/orders"}) {
    EXPECT_NE(std::find(shown.begin(), shown.end(), line), shown.end()) << line;
    const Ended ended = shell(line);
    EXPECT_EQ(ended.status, 0) << line << "\n" << ended.out << ended.err;
    printed += ended.out;
  }
  EXPECT_TRUE(holds(printed, "12 of 12 gate rows hold."));
  EXPECT_TRUE(holds(printed, "natural_1 decay_rate of elevation@right\n        50 mm "));
  EXPECT_TRUE(std::filesystem::exists(directory() / "../my_sph/whole/report/index.html"));
}

}  // namespace
}  // namespace slosh::your_code_study_test
