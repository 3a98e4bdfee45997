// A campaign's report as a browser shows it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "reports/tests/headless_browser.hpp"
#include "verification/tests/small_campaign.hpp"

namespace slosh::campaign_browser_test {
namespace {

class CampaignInBrowser : public SmallCampaign {};

int files_in(const std::filesystem::path& directory) {
  return static_cast<int>(std::distance(std::filesystem::directory_iterator(directory), {}));
}

TEST_F(CampaignInBrowser, ShowsItsVerdictItsGateRowsAndItsFigures) {
  if (!reports::browser_is_installed()) GTEST_SKIP() << "chromium is not installed";
  std::string second = with(gate_on("particles"), "limit = 0.3", "lower = 0.5\nupper = 0.6");
  second = with(with(second, "amplitude_error", "rms_error"), "\"forced\"", "\"whole\"");
  write_campaign(particles_case + second);
  ASSERT_EQ(campaign().status, 1);
  const auto shown = [&](const std::string& page, bool dark) {
    return reports::open_in_browser(directory(), "out/report/" + page, dark);
  };
  const reports::BrowserRun first = shown("index.html", false), run = shown("small.html", false),
                            appendix = shown("small-appendix.html", true);
  for (const reports::BrowserRun* one : {&first, &run, &appendix}) {
    EXPECT_EQ(reports::faults_of(*one), std::vector<std::string>{});
    EXPECT_LT(one->desk.at("weight"), 1'500'000);
    for (const std::string link : one->desk.at("links"))
      EXPECT_TRUE(std::filesystem::exists(report() / link.substr(0, link.find('#')))) << link;
  }
  for (const nlohmann::json& page : {first.desk, run.desk})
    EXPECT_EQ(page.at("verdict_first"), true);
  EXPECT_TRUE(holds(first.desk.at("verdict"), "SPH at 25 mm against linear theory: "));
  EXPECT_TRUE(holds(run.desk.at("verdict"), "1 of 2 gate rows hold, 1 violated."));
  const auto rows = [&](const char* table) {
    return run.desk.at("table_rows").at(table).get<int>();
  };
  EXPECT_EQ(rows("table-small-gate"), 1) << "the violated row";
  EXPECT_EQ(rows("table-small-gate-passing"), 1);
  EXPECT_EQ(run.desk.at("folded_reasons"), 2) << "each row has a reason of its own or is violated";
  const auto both = [&](const char* name) {
    return run.desk.at(name).get<int>() + appendix.desk.at(name).get<int>();
  };
  // On the case's page the tank, history, residual, sliding amplitude and lag, the forced phasor
  // and the natural one's, error against run time and memory; on its appendix the motion's
  // position, speed and acceleration, two forces, two momenta, highest surface and two spectra.
  // Beside them lie the case's small figure on the first page and the list of what Slosh has made.
  EXPECT_EQ(both("drawings"), 17);
  EXPECT_EQ(files_in(report() / "figures"), 19);
  EXPECT_GE(both("drawn_curves"), 12);
  ASSERT_EQ(first.desk.at("glances").size(), 1);
  EXPECT_EQ(first.desk.at("glances")[0].at("leads_to"), "small.html");
  EXPECT_TRUE(holds(first.desk.at("decision"),
                    "Decided by small: particles, rms error of elevation@right"));
  EXPECT_EQ(first.desk.at("table_rows").at("table-headline"), 1);
  EXPECT_EQ(first.desk.at("table_rows").at("table-worst"), 2);
}

// With a run of the paper's scheme, and a curve that the user digitised.
TEST_F(CampaignInBrowser, ShowsThePapersFiguresThatItsRunsRedraw) {
  if (!reports::browser_is_installed()) GTEST_SKIP() << "chromium is not installed";
  const std::string paper_run = with(with(particles_run, "particles", "li2010_25mm"),
                                     "scheme = \"recommended\"", "scheme = \"li2010\"");
  const std::string digitised = R"([[run]]
name = "figure_1"
solver = "record"
experiment = "li2010/figure_1.csv"
time_column = "t_s"
value_column = "eta_mm"
quantity = "elevation@right"
unit = "mm"
)";
  write("small.toml",
        with(particles_case, "\"small\"", "\"li2010_small_amplitude\"") + paper_run + digitised);
  write("surges.toml",
        "schema_version = 1\nname = \"surges\"\ntitle = \"Small surges\"\npaper = \"li2010\"\n"
        "source = \"made for a test\"\ncases = [\"./small.toml\"]\n");
  std::filesystem::create_directories(directory() / "records/li2010");
  write("records/li2010/figure_1.csv", "t_s,eta_mm\n0.1,1.0\n0.5,4.0\n2.0,-20.0\n8.0,9.0\n");
  const Ended ended =
      tool({"campaign", "./surges.toml", "--experiments", "records", "--output", "out"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  for (const bool dark : {false, true}) {
    const reports::BrowserRun run =
        reports::open_in_browser(directory(), "out/report/across.html", dark);
    EXPECT_EQ(reports::faults_of(run), std::vector<std::string>{});
    EXPECT_EQ(run.desk.at("drawings"), 1);
    EXPECT_GE(run.desk.at("drawn_curves"), 3) << "theory, particles and the paper's scheme";
  }
  const reports::BrowserRun first =
      reports::open_in_browser(directory(), "out/report/index.html", false);
  EXPECT_EQ(first.desk.at("table_rows").at("table-li2010-figures"), 7) << "figures of the paper";
  const std::string html = read(report() / "index.html");
  const std::string panel = "figure-li2010-figure-1-li2010_small_amplitude-elevation-right";
  EXPECT_TRUE(holds(read(report() / "across.html"), "id=\"" + panel + "\""));
  EXPECT_TRUE(holds(html, "href=\"across.html#" + panel + "\""));
  EXPECT_TRUE(holds(read(report() / "across.html"), "1: published record"));
  EXPECT_TRUE(holds(html, "not part of this campaign: "));
}

// The results of a campaign in which three models predict six amplitudes each.
nlohmann::json results_with_predictions(const std::string& name, double off) {
  nlohmann::json sets = nlohmann::json::array();
  for (const std::string model : {"recommended", "li2010", "interFoam"}) {
    nlohmann::json comparisons = nlohmann::json::array();
    for (int i = 0; i < 6; ++i)
      comparisons.push_back({{"case", name + "_" + std::to_string(i)},
                             {"candidate", "a"},
                             {"reference", "theory"},
                             {"quantity", "elevation@right"},
                             {"mode", "forced"},
                             {"predicted", 0.01 * (1 + off * (i % 3 - 0.8))},
                             {"reference_value", 0.01},
                             {"reference_relative_deviation", 0},
                             {"ratio_half_width_95", 0.01}});
    sets.push_back({{"quantity_kind", "elevation amplitude"},
                    {"unit", "m"},
                    {"model", model},
                    {"comparisons", comparisons}});
  }
  return {{"campaign", name},
          {"quick", false},
          {"exit_status", 0},
          {"model_bias", sets},
          {"cases",
           nlohmann::json::array({{{"gate", nlohmann::json::array({{{"verdict", "pass"}}})}}})},
          {"problems", nlohmann::json::array()}};
}

TEST_F(CampaignInBrowser, OfAllCampaignsIsOnePageWithTheBandOfEachModel) {
  if (!reports::browser_is_installed()) GTEST_SKIP() << "chromium is not installed";
  for (const auto& [name, off] : {std::pair{"first", 0.05}, std::pair{"second", 0.02}}) {
    std::filesystem::create_directories(directory() / "out" / name / "report");
    write("out/" + std::string(name) + "/report/results.json",
          results_with_predictions(name, off).dump());
  }
  std::filesystem::create_directories(directory() / "out/broken/report");
  write("out/broken/report/results.json", "{\"campaign\": 3}");
  const Ended ended = tool({"campaign", "--report-only", "--all", "--output", "out"});
  EXPECT_EQ(ended.status, 4) << "one cannot be read: " << ended.err;
  EXPECT_NE(ended.err.find("broken/report/results.json: "), std::string::npos) << ended.err;
  EXPECT_NE(ended.out.find("NOT COMPARED: 2 of 3 campaigns pass"), std::string::npos) << ended.out;
  for (const bool dark : {false, true}) {
    const reports::BrowserRun run =
        reports::open_in_browser(directory(), "out/report/index.html", dark);
    EXPECT_EQ(reports::faults_of(run), std::vector<std::string>{});
    EXPECT_EQ(run.desk.at("drawings"), 1);
    EXPECT_EQ(run.desk.at("table_rows").at("table-bias"), 3);
    EXPECT_EQ(run.desk.at("table_rows").at("table-campaigns"), 2);
    // The bands of the models stand side by side.
    const nlohmann::json& ribbons = run.desk.at("ribbons");
    ASSERT_EQ(ribbons.size(), 3);
    for (const nlohmann::json& ribbon : ribbons)
      EXPECT_GT(ribbon.at("bottom").get<int>() - ribbon.at("top").get<int>(), 20);
    EXPECT_LT(ribbons[0].at("right"), ribbons[1].at("left"));
    EXPECT_LT(ribbons[1].at("right"), ribbons[2].at("left"));
  }
}

TEST_F(CampaignInBrowser, OfAllCampaignsIsNoneWithoutAReport) {
  const Ended ended = tool({"campaign", "--report-only", "--all", "--output", "nowhere"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE(ended.err.find("--all: expected reports of campaigns"), std::string::npos) << ended.err;
  EXPECT_EQ(tool({"campaign", "--report-only"}).status, 2);
  EXPECT_EQ(tool({"campaign", "--report-only", "./surges.toml", "--all"}).status, 2);
}

}  // namespace
}  // namespace slosh::campaign_browser_test
