#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "reports/model/report_files.hpp"
#include "reports/pages/write_report.hpp"
#include "reports/tests/headless_browser.hpp"
#include "reports/tests/sample_report.hpp"
#include "reports/tests/test_environment.hpp"

namespace slosh::reports::browser_test {
namespace {

class Browser : public testing::Test {
 protected:
  void SetUp() override {
    if (!browser_is_installed()) GTEST_SKIP() << "chromium is not installed";
  }
  ScratchDirectory scratch_;
};

// A page's tables scroll in boxes that say so, and its figures fit.
void expect_fitting(const nlohmann::json& page) {
  EXPECT_LE(page.at("scroll_width"), page.at("width"));
  EXPECT_EQ(page.at("cut_figures"), 0);
  EXPECT_EQ(page.at("unhinted_boxes"), 0);
  EXPECT_GE(page.at("lowest_label"), 8);  // px
}

void expect_legible_report(const ScratchDirectory& scratch, bool dark) {
  write_report(sample_report(), scratch / "report");
  const BrowserRun run = open_in_browser(scratch.path(), "report/index.html", dark);
  EXPECT_EQ(run.log.find("CONSOLE"), std::string::npos) << run.log;
  EXPECT_EQ(run.phone.at("width"), 390);
  EXPECT_EQ(run.desk.at("width"), 1280);
  for (const nlohmann::json& page : {run.phone, run.desk}) {
    SCOPED_TRACE(page.dump(2));
    EXPECT_LE(page.at("scroll_width"), page.at("width"));
    EXPECT_EQ(page.at("tables"), 2);
    EXPECT_EQ(page.at("captions"), 2);
    EXPECT_EQ(page.at("headers_without_scope"), 0);
    EXPECT_EQ(page.at("figures"), 5);
    EXPECT_EQ(page.at("pictures"), 1);
    EXPECT_GE(page.at("smallest_picture"), 100);
    EXPECT_GE(page.at("picture_colours"), 30);  // of the 64 levels
    EXPECT_EQ(page.at("drawings"), 4);
    EXPECT_GE(page.at("smallest_drawing"), 100);  // clipped at 100 by the measure
    EXPECT_EQ(page.at("drawn_curves"), 11);       // three, two, three and three
    EXPECT_GE(page.at("text_contrast"), 4.5);     // WCAG 2.1, 1.4.3
    EXPECT_GE(page.at("page_contrast"), 4.5);
    EXPECT_GE(page.at("curve_contrast"), 3.0);  // WCAG 2.1, 1.4.11
    EXPECT_EQ(page.at("texts_outside"), nlohmann::json::array());
    EXPECT_EQ(page.at("texts_overlapping"), nlohmann::json::array());
    EXPECT_EQ(page.at("dark"), dark);
    EXPECT_TRUE(page.at("verdict_first"));
    EXPECT_EQ(page.at("repeated_ids"), 0);
    EXPECT_EQ(page.at("broken_links"), 0);
    EXPECT_EQ(page.at("scripts"), 0);
    expect_fitting(page);
  }
}

TEST_F(Browser, ShowsEveryTableAndFigureLegiblyOnAPhoneAndADesk) {
  expect_legible_report(scratch_, false);
}

TEST_F(Browser, ShowsTheSameInTheDarkScheme) { expect_legible_report(scratch_, true); }

// Heading levels start at the first and skip none on the way down.
bool in_order(const std::vector<int>& levels) {
  int last = 0;
  for (const int level : levels) {
    if (level > last + 1) return false;
    last = level;
  }
  return !levels.empty() && levels[0] == 1 && std::count(levels.begin(), levels.end(), 1) == 1;
}

// Whether a link such as "surge.html#row-3" works: the file exists and has an element of that id.
bool leads_somewhere(const std::filesystem::path& directory, const std::string& address) {
  const std::size_t hash = address.find('#');
  const std::filesystem::path file = directory / address.substr(0, hash);
  if (!std::filesystem::is_regular_file(file)) return false;
  return hash == address.npos ||
         read_text(file).find(" id=\"" + address.substr(hash + 1) + "\"") != std::string::npos;
}

TEST_F(Browser, GoesFromEveryPageToTheOthersByLinksAndKeyboard) {
  write_report(paged_report(), scratch_ / "report");
  std::set<std::string> linked;
  int drawings = 0, tables = 0;
  for (const char* name : {"index.html", "waves.html", "cost.html"}) {
    const BrowserRun run = open_in_browser(scratch_.path(), std::string("report/") + name, false);
    EXPECT_EQ(run.log.find("CONSOLE"), std::string::npos) << run.log;
    for (const nlohmann::json& page : {run.phone, run.desk}) {
      SCOPED_TRACE(std::string(name) + page.dump(2));
      EXPECT_LE(page.at("scroll_width"), page.at("width"));
      EXPECT_TRUE(in_order(page.at("heading_levels")));
      EXPECT_EQ(page.at("first_focus"), "skip");
      EXPECT_EQ(page.at("landmarks"), 3);
      EXPECT_EQ(page.at("unnamed_landmarks"), 0);
      EXPECT_EQ(page.at("captions"), page.at("tables"));
      EXPECT_EQ(page.at("headers_without_scope"), 0);
      EXPECT_EQ(page.at("repeated_ids"), 0);
      EXPECT_EQ(page.at("broken_links"), 0);
      EXPECT_GE(page.at("page_contrast"), 4.5);
      EXPECT_EQ(page.at("drawings").get<int>() + page.at("pictures").get<int>(),
                page.at("figures"));
      for (const std::string address : page.at("links")) {
        EXPECT_TRUE(leads_somewhere(scratch_ / "report", address)) << address;
        linked.insert(std::string(name) + " to " + address);
      }
    }
    drawings += run.desk.at("figures").get<int>();
    tables += run.desk.at("tables").get<int>();
  }
  EXPECT_EQ(drawings, 5);
  EXPECT_EQ(tables, 2);
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
  SCOPED_TRACE(page.dump(2));
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
  EXPECT_LE(page.at("scroll_width"), page.at("width"));
  EXPECT_EQ(page.at("texts_outside"), nlohmann::json::array());
  EXPECT_EQ(page.at("texts_overlapping"), nlohmann::json::array());
  EXPECT_EQ(page.at("repeated_ids"), 0);
}

TEST_F(Browser, ShowsAllCasesAtAGlanceOnTheFirstScreenLightAndDark) {
  write_report(report_of_eight_cases(), scratch_ / "report");
  for (const bool dark : {false, true}) {
    const BrowserRun run = open_in_browser(scratch_.path(), "report/index.html", dark);
    EXPECT_EQ(run.log.find("CONSOLE"), std::string::npos) << run.log;
    for (const nlohmann::json& page : {run.phone, run.desk}) {
      expect_small_multiples(page, 8);
      EXPECT_EQ(page.at("glance_legend"),
                (nlohmann::json{"reference", "SPH recommended", "interFoam (VOF)"}));
      EXPECT_EQ(page.at("decision"), "Decided by case 2: 10 mm: 7.2 ± 0.3 %, at most 5 %.");
      EXPECT_LT(page.at("verdict_box").at("bottom"), page.at("coverage_box").at("bottom"));
      EXPECT_LE(page.at("coverage_box").at("bottom"), page.at("glances")[0].at("card").at("top"));
      EXPECT_NE(page.at("glances")[2].at("verdict").get<std::string>().find("Fail"),
                std::string::npos);
      EXPECT_EQ(page.at("glances")[2].at("leads_to"), "case-2.html");
      EXPECT_GE(page.at("text_contrast"), 4.5);
      EXPECT_GE(page.at("curve_contrast"), 3.0);
    }
    // Four cases in a row: the first row is whole on the first screen of a desk, and the first case
    // begins on that of a phone.
    const nlohmann::json& desk = run.desk.at("glances");
    EXPECT_EQ(desk[3].at("card").at("top"), desk[0].at("card").at("top"));
    EXPECT_LE(desk[3].at("card").at("bottom"), run.desk.at("height"));
    EXPECT_LT(run.phone.at("glances")[0].at("card").at("top"), run.phone.at("height"));
  }
}

TEST_F(Browser, SeesCardsThatOverlapAndTextThatIsCutOff) {
  write_text(scratch_ / "broken.html",
             "<ol class=glances><li style='position:absolute;left:0;width:300px'><svg class=plot "
             "width=90 height=40><text x=80 y=20>cut off</text><text x=1 y=20>one</text><text x=5 "
             "y=22>other</text></svg><li style='position:absolute;"
             "left:200px;width:300px'><svg class=plot></svg></ol>");
  const nlohmann::json page = open_in_browser(scratch_.path(), "broken.html", false).phone;
  EXPECT_EQ(page.at("texts_outside"), (nlohmann::json{"cut off"}));
  EXPECT_EQ(page.at("texts_overlapping"), (nlohmann::json{"one / other"}));
  EXPECT_TRUE(overlap(page.at("glances")[0].at("card"), page.at("glances")[1].at("card")));
}

TEST_F(Browser, SeesAPageThatIsBroken) {
  write_text(
      scratch_ / "broken.html",
      "<body style='background:#fff'><div style='width:800px'>wide</div><p id=a><p id=a><a "
      "href='#nowhere'>x</a>"
      "<div class=scroll style='width:90px;overflow:auto'><p class=hint style='height:0;margin:0'>"
      "<div style='width:900px'>wide</div></div>"
      "<figure><svg style='margin-left:300px'><text "
      "fill='#ddd'>faint</text></svg></figure><figure><img src='nowhere.png' alt='a picture "
      "that is missing'></figure><script>console.error('trouble')</script>");
  const BrowserRun run = open_in_browser(scratch_.path(), "broken.html", false);
  EXPECT_NE(run.log.find("CONSOLE"), std::string::npos) << run.log;
  EXPECT_GT(run.phone.at("scroll_width"), 390);
  EXPECT_LT(run.phone.at("text_contrast"), 3.0);
  EXPECT_EQ(run.phone.at("repeated_ids"), 1);
  EXPECT_EQ(run.phone.at("unhinted_boxes"), 1);
  EXPECT_EQ(run.phone.at("cut_figures"), 1);
  EXPECT_EQ(run.phone.at("broken_links"), 1);
  EXPECT_EQ(run.phone.at("drawings"), 0);
  EXPECT_EQ(run.phone.at("pictures"), 0);
  EXPECT_EQ(run.phone.at("landmarks"), 0);
  EXPECT_NE(run.phone.at("first_focus"), "skip");
  EXPECT_FALSE(in_order({1, 3}));
  EXPECT_FALSE(in_order({2}));
  EXPECT_FALSE(in_order({1, 2, 1}));
  EXPECT_FALSE(leads_somewhere(scratch_.path(), "broken.html#nowhere"));
  EXPECT_FALSE(leads_somewhere(scratch_.path(), "missing.html"));
}

}  // namespace
}  // namespace slosh::reports::browser_test
