// An animation in a page: where its frames stand, and what the page says and allows of it.
#include "reports/fields/film_markup.hpp"

#include <gtest/gtest.h>

#include "reports/fields/field_layout.hpp"
#include "reports/model/base64.hpp"
#include "reports/model/text_file.hpp"
#include "reports/pages/check_report.hpp"
#include "reports/pages/write_html.hpp"
#include "reports/pages/write_report.hpp"
#include "reports/tests/sample_report.hpp"
#include "reports/tests/scratch_directory.hpp"

namespace slosh::reports::film_markup_test {
namespace {

FieldFigure film() {
  FieldFigure figure = sloshing_field("film", 4, 0.03);
  figure.panel_height = 120;
  figure.frames = {"t = 0 s", "t = <1> s", "t = 2 s", "t = 3 s"};
  return figure;
}

Report report_of(const FieldFigure& figure) {
  Report report;
  report.title = "Film";
  report.results_json = "{}";
  report.sections = {{"flow", "Flow", {}, {}, {}, {figure}}};
  return report;
}

std::string page_of(const FieldFigure& figure) {
  return html_pages(report_of(figure), {{}, {{"png bytes", 1000, 900}}}).at(0).text;
}

int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(Base64, IsThatOfRfc4648) {
  // Its section 10.
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(FilmFrames, HoldTheirPanelsAndDoNotOverlap) {
  const FieldFigure figure = film();
  const FieldLayout layout = field_layout(figure);
  const FilmFrames frames = film_frames(figure, layout);
  ASSERT_EQ(frames.tops.size(), 4u);
  EXPECT_GE(frames.tops[0], key_height);
  for (std::size_t row = 0; row < 4; ++row) {
    const PlacedPanel& panel = layout.panels[3 * row];
    EXPECT_LE(panel.height, 120);
    const double top = layout.height - panel.bottom - panel.height;
    EXPECT_LT(frames.tops[row], top);
    EXPECT_LE(top + panel.height, frames.tops[row] + frames.height + 1e-9);
    if (row > 0) {
      EXPECT_GE(frames.tops[row], frames.tops[row - 1] + frames.height);
    }
  }
}

TEST(FilmPage, HoldsOnePictureControlsAndTheScriptThatItsPolicyAllows) {
  const std::string page = page_of(film());
  EXPECT_EQ(count(page, "data:image/png;base64,"), 1);
  EXPECT_EQ(count(page, "<script>"), 1);
  EXPECT_NE(page.find("img-src data:; " + film_script_policy() + "\">"), std::string::npos);
  EXPECT_EQ(film_script_policy().size(), std::string("script-src 'sha256-'").size() + 44);
  EXPECT_NE(page.find("max=\"3\""), std::string::npos);
  EXPECT_NE(page.find("t = &lt;1&gt; s|t = 2 s"), std::string::npos);
  EXPECT_NE(page.find("role=\"img\" aria-label=\"Pressure in the rolling tank."),
            std::string::npos);
}

TEST(FilmPage, WithoutAFilmHasNoScriptAndAllowsNone) {
  FieldFigure still = film();
  still.frames.clear();
  const std::string page = page_of(still);
  EXPECT_EQ(page.find("script"), std::string::npos);
  EXPECT_EQ(page.find("film-frame\""), std::string::npos);
  EXPECT_NE(page.find("<img class=\"picture\""), std::string::npos);
}

TEST(FilmReport, NeedsAFrameForEachRow) {
  EXPECT_NO_THROW(check_report(report_of(film())));
  FieldFigure figure = film();
  figure.frames.pop_back();
  EXPECT_THROW(check_report(report_of(figure)), ReportError);
}

}  // namespace
}  // namespace slosh::reports::film_markup_test
