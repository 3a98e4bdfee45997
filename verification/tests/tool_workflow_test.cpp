// The workflow that docs/gating.md shows: its steps run as a forge runs them, on a small campaign.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "verification/tests/small_campaign.hpp"

namespace slosh::tool_workflow_test {
namespace {

namespace fs = std::filesystem;

class ToolWorkflow : public SmallCampaign {
 protected:
  struct Step {
    std::string command;
    bool always;  // also after a step that has failed
  };

  // The "run:" steps of the page's one yaml block, in their order.
  static std::vector<Step> steps() {
    std::ifstream page(SLOSH_SOURCE_DIR "/docs/gating.md");
    std::vector<Step> found;
    bool inside = false, always = false;
    for (std::string line; std::getline(page, line);) {
      if (line.starts_with("```")) inside = line == "```yaml";
      if (!inside) continue;
      const std::string text = line.substr(std::min(line.find_first_not_of(" -"), line.size()));
      if (line.find("- ") != line.npos) always = false;
      if (text == "if: always()") always = true;
      if (text.starts_with("run: ")) found.push_back({text.substr(5), always});
    }
    return found;
  }

  // In the directory as the checked-out repository; the status of the first step that fails.
  int run_job() const {
    int status = 0;
    for (const auto& [command, always] : steps()) {
      if (status != 0 && !always) continue;
      const Ended ended =
          end_of(start("/bin/sh", {"-ec", command},
                       {{"CAMPAIGN", "./surges.toml"},
                        {"GITHUB_STEP_SUMMARY", (directory() / "summary.md").string()}}));
      if (status == 0) status = ended.status;
    }
    return status;
  }

  void check_out(const std::string& case_text) const {
    write_campaign(case_text);
    write("slosh", "#!/bin/sh\nexec '" SLOSH_TOOL "' \"$@\"\n");
    fs::permissions(directory() / "slosh", fs::perms::owner_all);
  }
};

const std::string quick_particles =
    with(particles_run, "0.025\n", "0.025\nquick = true\n") + gate_on("particles");

TEST_F(ToolWorkflow, PassesAChangeThatKeepsTheTolerancesAndLeavesItsFiles) {
  ASSERT_GE(steps().size(), 2u);
  check_out(small_case + quick_particles);
  EXPECT_EQ(run_job(), 0);
  for (const char* file : {"junit.xml", "gate.md"})
    EXPECT_TRUE(fs::exists(directory() / "gate/gate" / file)) << file;
  EXPECT_TRUE(holds(read("summary.md"), "1 of 1 gate rows hold"));
}

TEST_F(ToolWorkflow, FailsAChangeThatDoesNotAndStillTellsWhy) {
  check_out(small_case + with(quick_particles, "limit = 0.3", "lower = 0.5\nupper = 0.6"));
  EXPECT_EQ(run_job(), 1);
  EXPECT_TRUE(holds(read("summary.md"), "1 violated"));
  EXPECT_TRUE(holds(read("gate/gate/junit.xml"), "<failure"));
}

}  // namespace
}  // namespace slosh::tool_workflow_test
