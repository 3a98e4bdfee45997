// A campaign's report as a browser shows it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "reports/tests/headless_browser.hpp"
#include "verification/tests/small_campaign.hpp"

namespace slosh::campaign_browser_test {
namespace {

class CampaignInBrowser : public SmallCampaign {};

std::size_t files_in(const std::filesystem::path& directory) {
  return static_cast<std::size_t>(
      std::distance(std::filesystem::directory_iterator(directory), {}));
}

TEST_F(CampaignInBrowser, ShowsItsVerdictItsGateRowsAndItsFigures) {
  if (!reports::browser_is_installed()) GTEST_SKIP() << "chromium is not installed";
  std::string second = with(gate_on("particles"), "limit = 0.3", "lower = 0.5\nupper = 0.6");
  second = with(with(second, "amplitude_error", "rms_error"), "\"forced\"", "\"whole\"");
  write_campaign(particles_case + second);
  ASSERT_EQ(campaign().status, 1);
  const nlohmann::json results = nlohmann::json::parse(read(report() / "results.json"));
  const reports::BrowserRun first =
      reports::open_in_browser(directory(), "out/report/index.html", false);
  const reports::BrowserRun run =
      reports::open_in_browser(directory(), "out/report/small.html", false);
  EXPECT_EQ((first.log + run.log).find("CONSOLE"), std::string::npos) << first.log << run.log;
  for (const nlohmann::json& page : {first.phone, first.desk, run.phone, run.desk}) {
    SCOPED_TRACE(page.dump(2));
    EXPECT_EQ(page.at("verdict_first"), true);
    EXPECT_NE(page.at("verdict").get<std::string>().find("1 of 2 gate rows hold, 1 violated."),
              std::string::npos);
    EXPECT_EQ(page.at("captions"), page.at("tables"));
    EXPECT_EQ(page.at("first_focus"), "skip");
    EXPECT_LE(page.at("scroll_width"), page.at("width"));
    EXPECT_EQ(page.at("repeated_ids"), 0);
    EXPECT_EQ(page.at("broken_links"), 0);
    for (const std::string link : page.at("links"))
      EXPECT_TRUE(std::filesystem::exists(report() / link.substr(0, link.find('#')))) << link;
  }
  for (const nlohmann::json& page : {run.phone, run.desk}) {
    SCOPED_TRACE(page.dump(2));
    EXPECT_EQ(page.at("table_rows").at("table-small-gate"),
              results.at("cases").at(0).at("gate").size());
    EXPECT_EQ(page.at("table_rows").at("table-small-cost-table"), 2);  // theory and particles
    EXPECT_EQ(page.at("drawings"), files_in(report() / "figures"));
    // History, residual, sliding amplitude and lag, the forced phasor and the natural one's, two
    // forces, two momenta, highest surface, two spectra, error against run time and memory; the
    // first page has none, for two modes are too few comparisons.
    EXPECT_EQ(page.at("drawings"), 13);
    EXPECT_GE(page.at("smallest_drawing"), 100);
    // Theory's elevation, its spectrum and its force beside all of the particles'.
    EXPECT_GE(page.at("drawn_curves"), 12);
  }
  EXPECT_EQ(first.desk.at("drawings"), 0);
  EXPECT_EQ(first.desk.at("table_rows").at("table-matrix"), 1);
  EXPECT_EQ(first.desk.at("table_rows").at("table-worst"), 2);
}

TEST_F(CampaignInBrowser, IsPrintedToAPdfWhereThatIsAskedFor) {
  if (!reports::browser_is_installed()) GTEST_SKIP() << "chromium is not installed";
  write_campaign(particles_case);
  const Ended printed = tool({"campaign", "./surges.toml", "--output", "out", "--pdf"});
  EXPECT_EQ(printed.status, 0) << printed.err;
  EXPECT_NE(printed.out.find("PDF: " + (report() / "report.pdf").string()), std::string::npos);
  EXPECT_EQ(read(report() / "report.pdf").substr(0, 5), "%PDF-");
}

TEST_F(CampaignInBrowser, IsNotBegunWhereAPdfIsAskedForAndNothingCanPrintIt) {
  write_campaign(particles_case);
  const Ended refused =
      tool({"campaign", "./surges.toml", "--output", "out", "--pdf"}, {{"PATH", "/nowhere"}});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("--pdf: chromium, which prints the report to PDF, is not on the PATH"),
            std::string::npos)
      << refused.err;
  EXPECT_FALSE(std::filesystem::exists(result("theory")));
}

}  // namespace
}  // namespace slosh::campaign_browser_test
