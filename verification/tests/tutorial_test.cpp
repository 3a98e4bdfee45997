// The commands of docs/tutorial.md and the comparison of docs/other_solvers.md, from the first to
// the last, on the shipped files.
#include <gtest/gtest.h>

#include <filesystem>

#include "verification/tests/small_campaign.hpp"

namespace slosh::tutorial_test {
namespace {

namespace fs = std::filesystem;

class Tutorial : public SmallCampaign {};

TEST_F(Tutorial, EndsWithTheVerdictsAndTheFilesThatItsPageShows) {
  if (!has_interfoam()) GTEST_SKIP() << "interFoam is not installed";
  fs::create_directory_symlink(fs::path(SLOSH_SOURCE_DIR) / "docs", directory() / "docs");
  const Ended explained = tool({"explain", "docs/tutorial/own_tank.toml"});
  EXPECT_EQ(explained.status, 0) << explained.err;
  EXPECT_TRUE(holds(explained.out, "0.851"));
  const Ended campaign = tool({"campaign", "docs/tutorial/campaign.toml", "-o", "own_tank"});
  EXPECT_EQ(campaign.status, 0) << campaign.out << campaign.err;
  EXPECT_TRUE(holds(campaign.out, "5 of 5 gate rows hold."));
  EXPECT_TRUE(fs::exists(directory() / "own_tank/report/index.html"));
  const Ended shown = tool({"show", "docs/tutorial/own_tank.toml", "-o", "own_tank.png"});
  EXPECT_EQ(shown.status, 0) << shown.err;
  EXPECT_GT(fs::file_size(directory() / "own_tank.png"), 10'000u);
  const Ended tried = tool({"selftest", "docs/tutorial/campaign.toml", "-o", "own_tank"});
  EXPECT_EQ(tried.status, 0) << tried.out << tried.err;
  // As docs/other_solvers.md compares a result of one's own with linear theory.
  const std::string runs = "own_tank/runs/own_tank/";
  const Ended compared =
      tool({"compare", runs + "recommended_5mm.h5", runs + "linear.h5", "--case",
            "docs/tutorial/own_tank.toml", "--gauge", "right", "--limit", "amplitude_error=0.03",
            "--limit", "phase_lag=2", "--json", "compared.json"});
  // As the tutorial says, linear theory does not have the history, and the forced mode is
  // undecided.
  EXPECT_EQ(compared.status, 5) << compared.out << compared.err;
  EXPECT_TRUE(holds(compared.out, "normalised rms: 97 ±"));
  EXPECT_TRUE(fs::exists(directory() / "compared.json"));
}

}  // namespace
}  // namespace slosh::tutorial_test
