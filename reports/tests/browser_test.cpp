#include <gtest/gtest.h>

#include <boost/process.hpp>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "reports/tests/sample_report.hpp"
#include "reports/tests/scratch_directory.hpp"
#include "reports/text_file.hpp"
#include "reports/write_report.hpp"

namespace slosh::reports {
namespace {

namespace process = boost::process;

// Shows a page in a frame of the phone's width and in one of a desk's, and leaves what it measures
// as text. Contrasts are WCAG 2.1's, against the page's own background.
constexpr const char* measuring_page = R"(<!DOCTYPE html><title>measure</title>
<iframe src="PAGE" style="width:390px;height:800px;border:0"></iframe>
<iframe src="PAGE" style="width:1200px;height:800px;border:0"></iframe>
<pre id="measures"></pre>
<script>
const luminance = colour => {
  const [r, g, b] = colour.match(/[\d.]+/g).map(c => c / 255).map(c => c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
};
const contrast = (a, b) => {
  const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y);
  return (high + 0.05) / (low + 0.05);
};
const measure = frame => {
  const page = frame.contentDocument, all = query => [...page.querySelectorAll(query)];
  const style = element => frame.contentWindow.getComputedStyle(element);
  const background = style(page.body).backgroundColor;
  const lowest = values => Math.min(100, ...values);
  const ids = all('[id]').map(element => element.id);
  return {
    width: page.documentElement.clientWidth,
    scroll_width: page.documentElement.scrollWidth,
    tables: all('table').length,
    captions: all('table > caption').length,
    headers_without_scope: all('th:not([scope])').length,
    figures: all('figure > figcaption').length,
    drawings: all('figure svg[role=img] > title').length,
    smallest_drawing: lowest(all('figure svg').map(svg => Math.min(svg.getBoundingClientRect().width, svg.getBoundingClientRect().height))),
    drawn_curves: all('svg [id*=gnuplot_plot] path').filter(path => path.getTotalLength() > 100).length,
    text_contrast: lowest(all('svg text').map(text => contrast(style(text).fill, background))),
    curve_contrast: lowest(all('svg [id*=gnuplot_plot] path').filter(p => style(p).stroke !== 'none').map(p => contrast(style(p).stroke, background))),
    page_contrast: lowest(all('h1, p, th, td, figcaption, .detail, a').map(element => contrast(style(element).color, background))),
    dark: luminance(background) < 0.2,
    verdict_first: all('h1, h2, p, table')[1]?.className.startsWith('verdict') ?? false,
    repeated_ids: ids.length - new Set(ids).size,
    broken_links: all('a[href^="#"], use').filter(a => !page.getElementById(a.getAttribute('href').slice(1))).length,
    scripts: all('script').length,
  };
};
addEventListener('load', () => {
  document.getElementById('measures').textContent = JSON.stringify([...document.querySelectorAll('iframe')].map(measure));
});
</script>)";

struct BrowserRun {
  nlohmann::json phone, desk;
  std::string log;
};

// Opens the page in headless Chromium. A browser that has not answered within a minute is ended:
// the test fails.
BrowserRun open_in_browser(const ScratchDirectory& scratch, const std::string& page, bool dark) {
  std::string frame = measuring_page;
  for (auto at = frame.find("PAGE"); at != std::string::npos; at = frame.find("PAGE"))
    frame.replace(at, 4, page);
  write_text(scratch / "measure.html", frame);
  const auto output = scratch / "dom.html", log = scratch / "browser.log";
  const std::vector<std::string> arguments{
      "--headless",
      "--no-sandbox",
      "--disable-gpu",
      "--disable-background-networking",
      "--no-first-run",
      "--disable-component-update",
      "--disable-sync",
      "--enable-logging=stderr",
      "--allow-file-access-from-files",
      "--window-size=1700,900",
      "--hide-scrollbars",
      dark ? "--blink-settings=preferredColorScheme=0" : "--blink-settings=preferredColorScheme=1",
      "--user-data-dir=" + (scratch / "profile").string(),
      "--dump-dom",
      "file://" + (scratch / "measure.html").string()};
  process::group group;
  process::child browser(process::search_path("chromium"), process::args(arguments),
                         process::std_in<process::null, process::std_out> output.string(),
                         process::std_err > log.string(), group);
  if (!browser.wait_for(std::chrono::seconds(60))) {
    group.terminate();
    throw std::runtime_error("chromium did not answer within 60 s: " + read_text(log));
  }
  const std::string dom = read_text(output), opening = "<pre id=\"measures\">";
  const auto start = dom.find(opening), end = dom.find("</pre>");
  if (start == std::string::npos || end == std::string::npos)
    throw std::runtime_error("no measures in: " + dom);
  const auto measures =
      nlohmann::json::parse(dom.substr(start + opening.size(), end - start - opening.size()));
  return {measures.at(0), measures.at(1), read_text(log)};
}

class Browser : public testing::Test {
 protected:
  void SetUp() override {
    if (process::search_path("chromium").empty()) GTEST_SKIP() << "chromium is not installed";
  }
  ScratchDirectory scratch_;
};

void expect_legible_report(const ScratchDirectory& scratch, bool dark) {
  write_report(sample_report(), scratch / "report");
  const BrowserRun run = open_in_browser(scratch, "report/index.html", dark);
  EXPECT_EQ(run.log.find("CONSOLE"), std::string::npos) << run.log;
  EXPECT_EQ(run.phone.at("width"), 390);
  for (const nlohmann::json& page : {run.phone, run.desk}) {
    SCOPED_TRACE(page.dump(2));
    EXPECT_LE(page.at("scroll_width"), page.at("width"));
    EXPECT_EQ(page.at("tables"), 2);
    EXPECT_EQ(page.at("captions"), 2);
    EXPECT_EQ(page.at("headers_without_scope"), 0);
    EXPECT_EQ(page.at("figures"), 4);
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

TEST_F(Browser, SeesAPageThatIsBroken) {
  write_text(scratch_ / "broken.html",
             "<body style='background:#fff'><div style='width:800px'>wide</div><p id=a><p id=a><a "
             "href='#nowhere'>x</a>"
             "<svg><text fill='#ddd'>faint</text></svg><script>console.error('trouble')</script>");
  const BrowserRun run = open_in_browser(scratch_, "broken.html", false);
  EXPECT_NE(run.log.find("CONSOLE"), std::string::npos) << run.log;
  EXPECT_GT(run.phone.at("scroll_width"), 390);
  EXPECT_LT(run.phone.at("text_contrast"), 3.0);
  EXPECT_EQ(run.phone.at("repeated_ids"), 1);
  EXPECT_EQ(run.phone.at("broken_links"), 1);
  EXPECT_EQ(run.phone.at("drawings"), 0);
}

}  // namespace
}  // namespace slosh::reports
