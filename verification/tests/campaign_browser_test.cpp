// A campaign's report as a browser shows it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "reports/tests/headless_browser.hpp"
#include "verification/tests/small_campaign.hpp"

namespace slosh {
namespace {

class CampaignInBrowser : public SmallCampaign {};

std::size_t files_in(const std::filesystem::path& directory) {
  return static_cast<std::size_t>(
      std::distance(std::filesystem::directory_iterator(directory), {}));
}

TEST_F(CampaignInBrowser, ShowsItsVerdictItsGateRowsAndItsFigures) {
  if (!reports::browser_is_installed()) GTEST_SKIP() << "chromium is not installed";
  write_campaign(particles_case +
                 with(gate_on("particles"), "limit = 0.3", "lower = 0.5\nupper = 0.6"));
  ASSERT_EQ(campaign().status, 1);
  const nlohmann::json results = nlohmann::json::parse(read(report() / "results.json"));
  const reports::BrowserRun run =
      reports::open_in_browser(directory(), "out/report/index.html", false);
  EXPECT_EQ(run.log.find("CONSOLE"), std::string::npos) << run.log;
  for (const nlohmann::json& page : {run.phone, run.desk}) {
    SCOPED_TRACE(page.dump(2));
    EXPECT_EQ(page.at("verdict_first"), true);
    EXPECT_NE(page.at("verdict").get<std::string>().find("1 of 2 gate rows hold, 1 violated."),
              std::string::npos);
    EXPECT_EQ(page.at("table_rows").at("table-gate"), results.at("cases").at(0).at("gate").size());
    EXPECT_EQ(page.at("table_rows").at("table-small-cost-table"), 2);  // theory and particles
    EXPECT_EQ(page.at("drawings"), files_in(report() / "figures"));
    // History, residual, two forces, two momenta, highest surface, two spectra, error against run
    // time.
    EXPECT_EQ(page.at("drawings"), 10);
    EXPECT_GE(page.at("smallest_drawing"), 100);
    // Theory's elevation, its spectrum and its force beside all of the particles'.
    EXPECT_GE(page.at("drawn_curves"), 12);
    EXPECT_LE(page.at("scroll_width"), page.at("width"));
    EXPECT_EQ(page.at("repeated_ids"), 0);
    EXPECT_EQ(page.at("broken_links"), 0);
  }
}

}  // namespace
}  // namespace slosh
