// The commands of docs/tutorial.md and the comparison of docs/other_solvers.md, from the first to
// the last, on the shipped files. The run of interFoam, a third of the time, is left to `--all`.
#include <gtest/gtest.h>

#include <filesystem>

#include "reports/model/report_files.hpp"
#include "verification/tests/documents.hpp"
#include "verification/tests/small_campaign.hpp"

namespace slosh::tutorial_test {
namespace {

namespace fs = std::filesystem;

class Tutorial : public SmallCampaign {
 protected:
  Tutorial() {
    fs::create_directory(directory() / "docs");
    fs::copy(SLOSH_SOURCE_DIR "/docs/tutorial", directory() / "docs/tutorial");
  }

  void expect_what_the_page_says() {
    const Ended explained = tool({"explain", "docs/tutorial/own_tank.toml"});
    EXPECT_EQ(explained.status, 0) << explained.err;
    EXPECT_TRUE(holds(explained.out, "0.851"));
    const Ended campaign = tool({"campaign", "docs/tutorial/campaign.toml", "-o", "own_tank"});
    EXPECT_EQ(campaign.status, 0) << campaign.out << campaign.err;
    // The rows up to their values, which belong to one machine.
    const auto rows =
        documents::all_matches(reports::read_text(SLOSH_SOURCE_DIR "/docs/tutorial.md"),
                               R"(\n    ((?:pass|PASS|\d of \d)[^:\n]*[:.]))");
    EXPECT_EQ(rows.size(), 7u);
    for (const std::string& row : rows) EXPECT_TRUE(holds(campaign.out, row)) << campaign.out;
    EXPECT_TRUE(fs::exists(directory() / "own_tank/report/index.html"));
    const Ended shown = tool({"show", "docs/tutorial/own_tank.toml", "-o", "own_tank.png"});
    EXPECT_EQ(shown.status, 0) << shown.err;
    EXPECT_GT(fs::file_size(directory() / "own_tank.png"), 10'000u);
    const Ended tried =
        tool({"gate", "--selftest", "docs/tutorial/campaign.toml", "-o", "own_tank"});
    EXPECT_EQ(tried.status, 0) << tried.out << tried.err;
  }
};

TEST_F(Tutorial, EndsWithTheVerdictsAndTheFilesThatItsPageShows) {
  const std::string file = "docs/tutorial/own_tank.toml", text = read(file);
  const std::size_t mesh = text.find("  { name = \"interfoam_40x20\"");
  ASSERT_NE(mesh, text.npos);
  write(file, text.substr(0, mesh) + text.substr(text.find('\n', mesh) + 1));
  expect_what_the_page_says();
  // As docs/other_solvers.md compares a result of one's own with linear theory.
  const std::string runs = "own_tank/runs/own_tank/";
  const Ended compared =
      tool({"compare", runs + "recommended_5mm.h5", runs + "linear.h5", "--case",
            "docs/tutorial/own_tank.toml", "--gauge", "right", "--limit", "amplitude_error=0.03",
            "--limit", "phase_lag=2", "--json", "compared.json"});
  // As the tutorial says, linear theory does not have the history, and the forced mode is
  // undecided.
  EXPECT_EQ(compared.status, 5) << compared.out << compared.err;
  EXPECT_TRUE(holds(compared.out, "normalised rms: 80 ±"));
  EXPECT_TRUE(fs::exists(directory() / "compared.json"));
}

TEST_F(Tutorial, EndsAlikeWithInterFoam) {
  if (!has_interfoam()) GTEST_SKIP() << "interFoam is not installed";
  expect_what_the_page_says();
}

}  // namespace
}  // namespace slosh::tutorial_test
