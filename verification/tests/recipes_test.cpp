// The cases of docs/recipes.md, as a reader runs them.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "reports/model/report_files.hpp"
#include "verification/tests/small_campaign.hpp"

namespace slosh::recipes_test {
namespace {

namespace fs = std::filesystem;

class Recipes : public SmallCampaign {
 protected:
  Recipes() {
    for (const auto& file : fs::directory_iterator(SLOSH_SOURCE_DIR "/docs/recipes"))
      fs::copy(file, directory() / file.path().filename());
  }
};

TEST_F(Recipes, AreNamedByTheirPageAndEndGreen) {
  const std::string page = reports::read_text(SLOSH_SOURCE_DIR "/docs/recipes.md");
  int count = 0;
  for (const auto& file : fs::directory_iterator(SLOSH_SOURCE_DIR "/docs/recipes")) {
    const std::string name = file.path().filename().string();
    if (file.path().extension() != ".toml") continue;
    ++count;
    EXPECT_TRUE(holds(page, "(recipes/" + name + ")")) << name;
    const std::string text = reports::read_text(file);
    EXPECT_LE(std::ranges::count(text, '\n'), 35) << name;
    const Ended ended = tool({"campaign", "./" + name, "-o", file.path().stem().string()});
    EXPECT_EQ(ended.status, 0) << name << "\n" << ended.out << ended.err;
  }
  EXPECT_GE(count, 5);
}

TEST_F(Recipes, FailWhereTheirLimitDoesNotHold) {
  write("load_limit.toml", with(read("load_limit.toml"), "limit = 8000", "limit = 3500"));
  const Ended ended = tool({"campaign", "./load_limit.toml", "-o", "out"});
  EXPECT_EQ(ended.status, 1) << ended.out << ended.err;
  EXPECT_TRUE(holds(ended.out, "violated       load_limit sph")) << ended.out;
}

}  // namespace
}  // namespace slosh::recipes_test
