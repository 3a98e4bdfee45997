// Tests the markup of an animation: the positions of its frames, its controls and its policy.
#include "reports/fields/film_markup.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "reports/fields/field_layout.hpp"
#include "reports/model/report_files.hpp"
#include "reports/pages/check_report.hpp"
#include "reports/pages/report_documents.hpp"
#include "reports/pages/write_report.hpp"
#include "reports/tests/sample_report.hpp"
#include "reports/tests/test_environment.hpp"

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

TEST(FilmFrames, AreTheRowsOfThePicture) {
  const FieldFigure figure = film();
  const FieldLayout layout = field_layout(figure);
  EXPECT_LE(layout.cell_height, 120);
  const int frame_height = layout.row_height() - row_gap;
  const std::string element = film_element(figure, {"", layout.width, layout.height});
  const std::string shape =
      "aspect-ratio: " + std::to_string(layout.width) + " / " + std::to_string(frame_height);
  EXPECT_NE(element.find(shape), std::string::npos);
  std::istringstream positions(element.substr(element.find("data-positions=\"") + 16));
  for (int row = 0; row < 4; ++row) {
    double position = 0;  // [%] of what the picture is taller than a frame
    positions >> position;
    EXPECT_NEAR(position / 100 * (layout.height - frame_height), layout.row_top(row), 0.01);
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
