#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <tuple>

#include "reports/model/report_files.hpp"
#include "reports/pages/report_documents.hpp"
#include "reports/pages/write_report.hpp"
#include "reports/tests/headless_browser.hpp"
#include "reports/tests/sample_report.hpp"
#include "reports/tests/test_environment.hpp"
#include "verification/tests/messages.hpp"

namespace slosh::reports::browser_test {
namespace {

class Browser : public testing::Test {
 protected:
  void SetUp() override {
    if (!browser_is_installed()) GTEST_SKIP() << "chromium is not installed";
  }
  ScratchDirectory scratch_;
};

const std::vector<std::string> none;

TEST_F(Browser, ShowsEveryTableAndFigureLegiblyOnAPhoneAndADeskLightAndDark) {
  write_report(sample_report(), scratch_ / "report");
  for (const bool dark : {false, true}) {
    const BrowserRun run = open_in_browser(scratch_.path(), "report/index.html", dark);
    EXPECT_EQ(faults_of(run), none);
    EXPECT_EQ(run.phone.at("width"), 390);
    EXPECT_EQ(run.desk.at("width"), 1280);
    EXPECT_EQ(run.phone.at("wide_boxes"), 6) << "two tables and four drawings";
    EXPECT_EQ(run.desk.at("wide_boxes"), 0);
    for (const nlohmann::json& page : {run.phone, run.desk}) {
      EXPECT_EQ(page.at("tables"), 2);
      EXPECT_EQ(page.at("pictures"), 1);
      EXPECT_EQ(page.at("drawings"), 4);
      EXPECT_EQ(page.at("drawn_curves"), 11);  // three, two, three and three
      EXPECT_EQ(page.at("dark"), dark);
      EXPECT_TRUE(page.at("verdict_first"));
    }
  }
}

// Whether a link such as "surge.html#row-3" works: the file exists and has an element of that id.
bool leads_somewhere(const std::filesystem::path& directory, const std::string& address) {
  const std::size_t hash = address.find('#');
  const std::filesystem::path file = directory / address.substr(0, hash);
  if (!std::filesystem::is_regular_file(file)) return false;
  return hash == address.npos ||
         read_text(file).find(" id=\"" + address.substr(hash + 1) + "\"") != std::string::npos;
}

std::vector<int> counted(int last) {
  std::vector<int> numbers(static_cast<std::size_t>(last));
  std::iota(numbers.begin(), numbers.end(), 1);
  return numbers;
}

TEST_F(Browser, GoesFromEveryPageToTheOthersAndNumbersFiguresFromOneOnEach) {
  write_report(paged_report(), scratch_ / "report");
  std::set<std::string> linked;
  for (const auto& [name, figures, tables] :
       {std::tuple{"index.html", 0, 1}, {"waves.html", 4, 0}, {"cost.html", 1, 1}}) {
    const BrowserRun run = open_in_browser(scratch_.path(), std::string("report/") + name, false);
    EXPECT_EQ(faults_of(run), none) << name;
    EXPECT_EQ(run.desk.at("figure_numbers"), counted(figures)) << name;
    EXPECT_EQ(run.desk.at("table_numbers"), counted(tables)) << name;
    for (const std::string address : run.desk.at("links")) {
      EXPECT_TRUE(leads_somewhere(scratch_ / "report", address)) << address;
      linked.insert(std::string(name) + " to " + address);
    }
  }
  for (const char* link : {"index.html to waves.html", "index.html to cost.html#row-runs-2",
                           "waves.html to index.html", "waves.html to cost.html",
                           "cost.html to waves.html", "index.html to results.schema.json"})
    EXPECT_TRUE(linked.contains(link)) << link;
}

// A report of eight cases: each with a small figure of its history, some of which fail.
Report report_of_eight_cases() {
  Report report = sample_report();
  report.decision = {"Decided by", {"case 2: 10 mm", "section-cost"}, "7.2 ± 0.3 %, at most 5 %."};
  report.coverage = "Coverage: 40 of 40 declared rows are judged.";
  const Figure history = report.sections[1].figures[0];
  for (int i = 0; i < 8; ++i) {
    const std::string id = "case-" + std::to_string(i);
    Page page{id, "Case " + std::to_string(i) + " of a surging tank", "5 of 5 gate rows hold.",
              i == 2 ? Outcome::fail : Outcome::pass};
    page.glance = history;
    page.glance->id = id + "-glance";
    page.glance->caption = "elevation of linear, recommended_10mm, interfoam_50x100";
    page.glance->is_small = true;
    const Look looks[] = {{true, 0, 0}, {false, 0, 0}, {false, 1, 1}};
    const char* labels[] = {"reference", "SPH recommended", "interFoam (VOF)"};
    for (std::size_t j = 0; j < 3; ++j) {
      page.glance->curves[j].look = looks[j];
      page.glance->curves[j].label = labels[j];
      page.glance->curves[j].style = Curve::Style::line;
    }
    report.pages.push_back(page);
    report.sections.push_back({id, "Of it", {"Text."}, {}, {}, {}, id});
  }
  return report;
}

bool overlap(const nlohmann::json& a, const nlohmann::json& b) {
  const auto at = [](const nlohmann::json& box, const char* side) {
    return box.at(side).get<int>();
  };
  return at(a, "left") < at(b, "right") && at(b, "left") < at(a, "right") &&
         at(a, "top") < at(b, "bottom") && at(b, "top") < at(a, "bottom");
}

// Cards stand beside or below one another, inside the page, each around its drawing.
void expect_small_multiples(const nlohmann::json& page, std::size_t count) {
  const nlohmann::json& glances = page.at("glances");
  ASSERT_EQ(glances.size(), count);
  for (std::size_t i = 0; i < count; ++i) {
    const nlohmann::json &card = glances[i].at("card"), &drawing = glances[i].at("drawing");
    EXPECT_GE(card.at("left"), 0);
    EXPECT_LE(card.at("right"), page.at("width"));
    EXPECT_GE(drawing.at("left"), card.at("left"));
    EXPECT_LE(drawing.at("right"), card.at("right"));
    EXPECT_LE(drawing.at("bottom"), card.at("bottom"));
    EXPECT_GE(drawing.at("right").get<int>() - drawing.at("left").get<int>(), 250);
    EXPECT_GE(glances[i].at("smallest_text"), 9);  // px
    EXPECT_EQ(glances[i].at("colours"), page.at("legend_colours"));
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(card, glances[j].at("card")));
  }
}

TEST_F(Browser, ShowsAllCasesAtAGlanceOnTheFirstScreenLightAndDark) {
  write_report(report_of_eight_cases(), scratch_ / "report");
  for (const bool dark : {false, true}) {
    const BrowserRun run = open_in_browser(scratch_.path(), "report/index.html", dark);
    EXPECT_EQ(faults_of(run), none);
    for (const nlohmann::json& page : {run.phone, run.desk}) {
      expect_small_multiples(page, 8);
      EXPECT_EQ(page.at("glance_legend"),
                (nlohmann::json{"reference", "SPH recommended", "interFoam (VOF)"}));
      EXPECT_EQ(page.at("decision"), "Decided by case 2: 10 mm: 7.2 ± 0.3 %, at most 5 %.");
      EXPECT_TRUE(holds(page.at("glances")[2].at("verdict").get<std::string>(), "Fail"));
      EXPECT_EQ(page.at("glances")[2].at("leads_to"), "case-2.html");
    }
    // Four cases in a row: the first row is whole on the first screen of a desk, and the first case
    // begins on that of a phone.
    const nlohmann::json& desk = run.desk.at("glances");
    EXPECT_EQ(desk[3].at("card").at("top"), desk[0].at("card").at("top"));
    EXPECT_LE(desk[3].at("card").at("bottom"), run.desk.at("height"));
    EXPECT_LT(run.phone.at("glances")[0].at("card").at("top"), run.phone.at("height"));
  }
}

TEST_F(Browser, SeesEveryFaultOfABrokenPage) {
  write_text(
      scratch_ / "broken.html",
      "<body style='background:#fff'><div style='width:800px'>wide</div><p id=a><p id=a><a "
      "href='#nowhere'>x</a><nav></nav><h3>deep</h3><table><tr><th>x</table>"
      "<div class=scroll style='width:90px;overflow:auto'><p class=hint style='height:0;margin:0'>"
      "<div style='width:900px'>wide</div></div>"
      "<figure><svg class=plot style='margin-left:300px' width=90 height=40><text x=80 y=20 "
      "fill='#ddd' style='font-size:4px'>faint and cut off</text><text x=1 y=20>one</text><text "
      "x=5 y=22>other</text><g id=gnuplot_plot><path stroke='#eee' d='M0 0 L9 9'></g></svg>"
      "<figcaption>a figure without a name</figcaption></figure>"
      "<p style='color:#eee'>pale<figure><img src='nowhere.png' alt='a picture that is "
      "missing'></figure><ol class=glances><li style='position:absolute;left:0;width:300px'><svg>"
      "</svg><li style='position:absolute;left:200px;width:300px'><svg></svg></ol>"
      "<script>console.error('trouble')</script>");
  const BrowserRun run = open_in_browser(scratch_.path(), "broken.html", false);
  std::set<std::string> found;
  for (const std::string& fault : faults_of(run)) found.insert(fault.substr(0, fault.find(':')));
  EXPECT_EQ(found, (std::set<std::string>{"log",
                                          "headers_without_scope",
                                          "unnamed_landmarks",
                                          "repeated_ids",
                                          "broken_links",
                                          "scripts",
                                          "cut_figures",
                                          "unhinted_boxes",
                                          "texts_outside",
                                          "texts_overlapping",
                                          "text_contrast",
                                          "page_contrast",
                                          "curve_contrast",
                                          "lowest_label",
                                          "smallest_drawing",
                                          "scroll_width",
                                          "captions",
                                          "figures",
                                          "first_focus",
                                          "landmarks",
                                          "heading_levels"}));
  EXPECT_TRUE(
      overlap(run.phone.at("glances")[0].at("card"), run.phone.at("glances")[1].at("card")));
  EXPECT_FALSE(in_order({1, 2, 1}));
  EXPECT_FALSE(leads_somewhere(scratch_.path(), "broken.html#nowhere"));
  EXPECT_FALSE(leads_somewhere(scratch_.path(), "missing.html"));
}

// A table of 400 rows is cut on the page and whole in a file, and so are the curves of a figure.
TEST_F(Browser, IsShortAndLightWithFourHundredRuns) {
  Report report = sample_report();
  Section& section = report.sections[1];
  section.figures.assign(12, heavy_figure("heavy"));
  for (std::size_t i = 0; i < section.figures.size(); ++i) {
    section.figures[i].id += "-" + std::to_string(i);
    while (section.figures[i].curves.size() < 400)
      section.figures[i].curves.push_back(section.figures[i].curves[i % 6]);
  }
  Table table{"long", "Runs", "", {"run", "error [%]"}, {}};
  for (int i = 0; i < 400; ++i)
    table.rows.push_back({"run_" + std::to_string(i), std::to_string(i)});
  section.tables = {table};
  Table& gate = report.sections[0].tables[0];
  gate.reasons.assign(gate.rows.size(), "");
  gate.reasons[0] = gate.reasons[2] = "A good many words that tell why the limit is what it is.";
  write_report(report, scratch_ / "report");
  const BrowserRun run = open_in_browser(scratch_.path(), "report/index.html", false);
  EXPECT_EQ(faults_of(run), none);
  EXPECT_LT(run.desk.at("weight"), 1'500'000);
  EXPECT_EQ(run.desk.at("drawings"), 13);
  EXPECT_EQ(run.desk.at("folded_reasons"), 2);
  EXPECT_EQ(run.desk.at("table_rows").at("table-long"), 100);
  const std::string file = read_text(scratch_ / "report/tables/long.csv");
  EXPECT_EQ(std::count(file.begin(), file.end(), '\n'), 401);
  EXPECT_TRUE(file.ends_with("run_399,399\n"));
  const Figure drawn = with_legible_figures(report).sections[1].figures[0];
  EXPECT_EQ(drawn.curves.size(), most_curves);
  EXPECT_EQ(drawn.caption, "The first 24 of 400 curves are drawn.");
}

}  // namespace
}  // namespace slosh::reports::browser_test
