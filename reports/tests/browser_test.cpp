#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "reports/tests/headless_browser.hpp"
#include "reports/tests/sample_report.hpp"
#include "reports/tests/scratch_directory.hpp"
#include "reports/text_file.hpp"
#include "reports/write_report.hpp"

namespace slosh::reports {
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
  EXPECT_EQ(run.phone.at("width"), 390);
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

TEST_F(Browser, RunsTheScriptOfAFilmAndFitsItIntoThePage) {
  Report report = sample_report();
  FieldFigure film = sloshing_field("film", 3, 0.03);
  film.panel_height = 120;
  film.frames = {"t = 0 s", "t = 1 s", "t = 2 s"};
  report.sections[1].fields = {film};
  write_report(report, scratch_ / "report");
  const BrowserRun run = open_in_browser(scratch_.path(), "report/index.html", false);
  // A script that the page's policy does not allow is told of there.
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
  EXPECT_GT(run.phone.at("scroll_width"), 390);
  EXPECT_LT(run.phone.at("text_contrast"), 3.0);
  EXPECT_EQ(run.phone.at("repeated_ids"), 1);
  EXPECT_EQ(run.phone.at("broken_links"), 1);
  EXPECT_EQ(run.phone.at("drawings"), 0);
  EXPECT_EQ(run.phone.at("pictures"), 0);
}

}  // namespace
}  // namespace slosh::reports
