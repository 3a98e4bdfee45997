// Tests the markup of an animation: its panels, controls, cursor and policy.
#include "reports/fields/film_markup.hpp"

#include <gtest/gtest.h>

#include "reports/drawing/figure_layout.hpp"
#include "reports/pages/check_report.hpp"
#include "reports/pages/report_documents.hpp"
#include "reports/tests/sample_report.hpp"
#include "reports/tests/test_environment.hpp"

namespace slosh::reports::film_markup_test {
namespace {

FieldFigure film() {
  FieldFigure figure = sloshing_film("film", 4, 3, 0.03);
  figure.film->labels[1] = "t = <1> s";
  return figure;
}

Report report_of(const FieldFigure& figure) {
  Report report;
  report.title = "Film";
  report.results_json = "{}";
  report.sections = {{"flow", "Flow", {}, {}, {}, {figure}}};
  return report;
}

DrawnFilm drawn(const FieldFigure& figure) {
  const ScratchDirectory scratch;
  return draw_film(figure, scratch.path());
}

Drawings drawings_of(const FieldFigure& figure) {
  Drawings drawings{{}, {{"png bytes", 1000, 900}}};
  if (figure.film) drawings.films.push_back(drawn(figure));
  return drawings;
}

std::string page_of(const FieldFigure& figure) {
  return html_pages(report_of(figure), drawings_of(figure)).at(0).text;
}

int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(FilmPage, HoldsOnePictureOneKeyOneControlAndTheScriptThatItsPolicyAllows) {
  const std::string page = page_of(film());
  EXPECT_EQ(count(page, "data:image/png;base64,"), 1);
  EXPECT_EQ(count(page, "class=\"film-panel\""), 3);
  EXPECT_EQ(count(page, "class=\"plot film-bar\""), 1);
  EXPECT_EQ(count(page, "type=\"range\""), 1);
  EXPECT_EQ(count(page, "class=\"film-cursor\""), 1);
  EXPECT_EQ(count(page, "<script>"), 1);
  EXPECT_TRUE(holds(page, "img-src data:; " + film_script_policy() + "\">"));
  EXPECT_EQ(film_script_policy().size(), std::string("script-src 'sha256-'").size() + 44);
  EXPECT_TRUE(holds(page, "t = &lt;1&gt; s|t = 250 cs"));
  EXPECT_TRUE(
      holds(page, "role=\"img\" aria-label=\"SPH &lt;recommended&gt;. Colour: pressure (Pa)"));
}

TEST(FilmPage, StandsAtItsPosterWithItsTimeAndHidesWhatNeedsTheScript) {
  const std::string page = page_of(film());
  EXPECT_TRUE(holds(page, "--row: 66.67%"));  // the third of four
  EXPECT_TRUE(holds(page, "max=\"3\" value=\"2\""));
  EXPECT_TRUE(holds(page, "<output aria-live=\"off\">t = 250 cs</output>"));
  EXPECT_TRUE(holds(page, "<button type=\"button\" hidden>"));
  EXPECT_TRUE(holds(page, "aria-valuetext=\"t = 250 cs\" hidden>"));
}

TEST(FilmPage, TellsAtWhichMomentsARunRecordedNothing) {
  FieldFigure figure = film();
  EXPECT_EQ(count(page_of(figure), "data-moments=\"1\" hidden>not recorded"), 1);
  figure.film->poster = 1;
  EXPECT_EQ(count(page_of(figure), "data-moments=\"1\">not recorded"), 1);
}

TEST(FilmPage, OfTheWholeReportHasThePosterAndNoScript) {
  const std::string whole = whole_document(report_of(film()), drawings_of(film()));
  EXPECT_FALSE(holds(whole, "<script"));
  EXPECT_TRUE(holds(whole, "--row: 66.67%"));
}

TEST(FilmPage, WithoutAFilmHasNoScriptAndAllowsNone) {
  FieldFigure still = film();
  still.film.reset();
  const std::string page = page_of(still);
  EXPECT_FALSE(holds(page, "script"));
  EXPECT_FALSE(holds(page, "film-frame\""));
  EXPECT_TRUE(holds(page, "<img class=\"picture\""));
}

TEST(FilmCursor, StandsWhereTheFramesTimeIsOnTheAxis) {
  const DrawnFilm parts = drawn(film());
  const CursorFrame frame = cursor_frame(film().film->history);
  ASSERT_EQ(parts.cursors.size(), 4u);
  EXPECT_NEAR(parts.cursors[0], frame.left, 1e-9);
  EXPECT_NEAR(parts.cursors[3], frame.right, 1e-9);
  EXPECT_NEAR(parts.cursors[1], frame.left + (frame.right - frame.left) / 3, 1e-9);
  EXPECT_LT(frame.top, frame.bottom);
  EXPECT_LT(frame.right, parts.history.width);
  EXPECT_LT(frame.bottom, parts.history.height);
}

TEST(FilmCaption, TellsHowManyMomentsAreLeftOut) {
  DrawnFilm parts = drawn(film());
  EXPECT_EQ(film_caption(film(), parts), "Animation.");
  parts.strip.moments = {0, 2};
  EXPECT_EQ(film_caption(film(), parts),
            "Animation. To keep the page light, it plays 2 of these 4 moments.");
}

TEST(FilmReport, NeedsALabelANameAPosterAndAHistoryWithACursor) {
  EXPECT_NO_THROW(check_report(report_of(film())));
  const auto refused = [](const auto& spoil) {
    FieldFigure figure = film();
    spoil(figure);
    EXPECT_THROW(check_report(report_of(figure)), ReportError);
  };
  refused([](FieldFigure& f) { f.film->labels.pop_back(); });
  refused([](FieldFigure& f) { f.film->times.pop_back(); });
  refused([](FieldFigure& f) { f.film->names.pop_back(); });
  refused([](FieldFigure& f) { f.film->poster = 4; });
  refused([](FieldFigure& f) { f.film->history.has_cursor = false; });
  refused([](FieldFigure& f) { f.film->history.log_x = true; });
  refused([](FieldFigure& f) { f.film->history.markers = {{"here", 1}}; });
  refused([](FieldFigure& f) { f.film->history.curves[0].x.pop_back(); });
  refused([](FieldFigure& f) { f.film->history.id = f.id; });
}

}  // namespace
}  // namespace slosh::reports::film_markup_test
