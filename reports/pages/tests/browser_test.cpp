#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "reports/model/report_files.hpp"
#include "reports/pages/print_pdf.hpp"
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

void expect_legible_report(const ScratchDirectory& scratch, bool dark) {
  write_report(sample_report(), scratch / "report");
  const BrowserRun run = open_in_browser(scratch.path(), "report/index.html", dark);
  EXPECT_EQ(run.log.find("CONSOLE"), std::string::npos) << run.log;
  EXPECT_EQ(run.phone.at("width"), 360);
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
    EXPECT_EQ(page.at("dark"), dark);
    EXPECT_TRUE(page.at("verdict_first"));
    EXPECT_EQ(page.at("repeated_ids"), 0);
    EXPECT_EQ(page.at("broken_links"), 0);
    EXPECT_EQ(page.at("scripts"), 0);
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

// Returns the number of pages that Chromium's PDF states.
int pages_of_pdf(const std::string& pdf) {
  const std::regex page(R"(/Type /Page[^s])");
  return static_cast<int>(std::distance(std::sregex_iterator(pdf.begin(), pdf.end(), page), {}));
}

TEST_F(Browser, PrintsTheWholeReportToOnePdf) {
  write_report(paged_report(), scratch_ / "report", {.pdf = true});
  const std::string pdf = read_text(scratch_ / "report/report.pdf");
  EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
  EXPECT_GE(pages_of_pdf(pdf), 4);  // each page starts anew, and five figures do not go on three
  EXPECT_FALSE(std::filesystem::exists(scratch_ / "report/report.pdf.log"));
}

TEST_F(Browser, ThatDoesNotPrintInTimeIsEndedAndTold) {
  try {
    print_pdf("<p>Never.", scratch_.path(), scratch_ / "a.pdf", std::chrono::seconds(0));
    FAIL() << "printed in no time";
  } catch (const ReportError& error) {
    EXPECT_NE(std::string(error.what()).find("within 0 s"), std::string::npos) << error.what();
  }
  EXPECT_TRUE(std::filesystem::exists(scratch_ / "a.pdf.log"));
}

TEST_F(Browser, RunsTheScriptOfAFilmAndFitsItIntoThePage) {
  Report report = sample_report();
  FieldFigure film = sloshing_field("film", 3, 0.03);
  film.panel_height = 120;
  film.frames = {"t = 0 s", "t = 1 s", "t = 2 s"};
  report.sections[1].fields = {film};
  write_report(report, scratch_ / "report");
  const BrowserRun run = open_in_browser(scratch_.path(), "report/index.html", false);
  // The log names a script that the page's policy does not allow.
  EXPECT_EQ(run.log.find("CONSOLE"), std::string::npos) << run.log;
  for (const nlohmann::json& page : {run.phone, run.desk}) {
    EXPECT_EQ(page.at("scripts"), 1);
    EXPECT_LE(page.at("scroll_width"), page.at("width"));
  }
}

TEST_F(Browser, SeesAPageThatIsBroken) {
  write_text(
      scratch_ / "broken.html",
      "<body style='background:#fff'><div style='width:800px'>wide</div><p id=a><p id=a><a "
      "href='#nowhere'>x</a>"
      "<svg><text fill='#ddd'>faint</text></svg><figure><img src='nowhere.png' alt='a picture "
      "that is missing'></figure><script>console.error('trouble')</script>");
  const BrowserRun run = open_in_browser(scratch_.path(), "broken.html", false);
  EXPECT_NE(run.log.find("CONSOLE"), std::string::npos) << run.log;
  EXPECT_GT(run.phone.at("scroll_width"), 360);
  EXPECT_LT(run.phone.at("text_contrast"), 3.0);
  EXPECT_EQ(run.phone.at("repeated_ids"), 1);
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
  EXPECT_EQ(pages_of_pdf("/Type /Pages"), 0);
}

}  // namespace
}  // namespace slosh::reports::browser_test
