// How a figure draws curves that have a look, that set no scale, or that stand in a small figure.
#include <gtest/gtest.h>

#include <algorithm>

#include "reports/drawing/draw_figure.hpp"
#include "reports/drawing/figure_layout.hpp"
#include "reports/drawing/gnuplot_script.hpp"
#include "reports/tests/test_environment.hpp"
#include "verification/tests/messages.hpp"

namespace slosh::reports::figure_look_test {
namespace {

Curve curve_named(const std::string& label, double height) {
  Curve curve{label, {}, {}, {}, Curve::Style::line};
  for (int i = 0; i <= 100; ++i) {
    curve.x.push_back(i);
    curve.y.push_back(height * (i % 2 ? 1 : -1));
  }
  return curve;
}

Figure figure_of(const std::vector<Curve>& curves) {
  Figure figure;
  figure.id = "figure";
  figure.title = "title";
  figure.curves = curves;
  return figure;
}

// The line of the script that plots the curve.
std::string element(const Figure& figure, const std::string& label) {
  const std::string script = gnuplot_script(figure);
  const std::size_t end = script.find("title '" + label + "'");
  const std::size_t begin = script.rfind("$curve_", end);
  return script.substr(begin, end - begin);
}

TEST(Look, IsTheSameAtEveryPlaceOfAFigure) {
  Curve run = curve_named("run", 1), other = curve_named("other", 2);
  run.look = Look{false, 2, 3};
  const auto looks = [&](const Figure& figure) {
    const std::string text = element(figure, "run");
    return text.substr(text.find(" with "));
  };
  const std::string first = looks(figure_of({run, other}));
  EXPECT_EQ(first, looks(figure_of({other, other, run})));
  const Stroke stroke = stroke_of(*run.look);
  EXPECT_TRUE(holds(first, stroke.colour));
  EXPECT_TRUE(holds(first, " pt " + std::to_string(stroke.point) + " "));
}

TEST(Look, OfAReferenceIsBlackOrGreyAndHasNoMarkersOnItsLine) {
  Curve theory = curve_named("theory", 1), record = theory;
  theory.look = Look{true, 0, 0};
  record.look = Look{true, 1, 0};
  record.label = "record";
  const Figure figure = figure_of({theory, record});
  EXPECT_TRUE(holds(element(figure, "theory"), "#1f2933"));
  EXPECT_TRUE(holds(element(figure, "record"), "#67727e"));
  EXPECT_FALSE(holds(element(figure, "theory"), " pt "));
}

TEST(Look, OfABandIsTheColourOfItsCurve) {
  Figure figure = figure_of({curve_named("run", 1)});
  figure.bands = {{"of the run", -1, 1, Look{false, 4, 0}}, {"of none", -2, 2}};
  const std::string script = gnuplot_script(figure), run = stroke_of({false, 4, 0}).colour;
  const std::size_t rectangle = script.find("set object rectangle");
  EXPECT_EQ(script.find("fc rgb '" + run, rectangle), script.find("fc rgb '", rectangle));
  EXPECT_NE(band_colour(figure, 1), run);
}

TEST(Look, HasNoMarkersOnALevelWhereTheyWouldLookLikeData) {
  Curve level{"level", {0, 1}, {1, 1}, {}, Curve::Style::line};
  level.look = Look{false, 0, 0};
  EXPECT_FALSE(holds(element(figure_of({level}), "level"), " pt "));
}

TEST(Look, IsAnotherForEachRunOfAFamilyOfFour) {
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Stroke one = stroke_of({false, 0, i}), other = stroke_of({false, 0, j});
      EXPECT_NE(one.point, other.point);
      EXPECT_STRNE(one.dash, other.dash);
    }
}

TEST(CurveWithoutScale, IsThinAndLeavesTheAxisToTheOthers) {
  Curve far = curve_named("far", 1000);
  const Figure both = figure_of({curve_named("near", 1), far});
  EXPECT_GT(plot_ranges(both).vertical.upper, 1000);
  far.sets_scale = false;
  const Figure cut = figure_of({curve_named("near", 1), far});
  EXPECT_LT(plot_ranges(cut).vertical.upper, 2);
  EXPECT_EQ(plot_ranges(cut).vertical.upper,
            plot_ranges(figure_of({curve_named("near", 1)})).vertical.upper);
  EXPECT_TRUE(holds(element(both, "far"), "lw 1.8"));
  EXPECT_TRUE(holds(element(cut, "far"), "lw 0.81")) << element(cut, "far");
  const Figure alone = figure_of({far});
  EXPECT_GT(plot_ranges(alone).vertical.upper, 1000);  // there is nothing else to see
}

TEST(SmallFigure, HasASmallCanvasAndNoLegend) {
  Figure figure = figure_of({curve_named("a run of a long name", 1)});
  const int whole = canvas_height(figure);
  figure.is_small = true;
  EXPECT_LT(canvas_height(figure), whole / 1.5);
  const ScratchDirectory scratch;
  const DrawnFigure drawn = draw_figure(figure, scratch.path());
  EXPECT_EQ(drawn.width, canvas_of(figure).width);
  // The curve's group has its name for readers who do not see it; a legend would repeat it.
  const std::string name = "a run of a long name";
  EXPECT_EQ(drawn.markup.find(name), drawn.markup.rfind(name));
  EXPECT_TRUE(holds(drawn.markup, "#0069a8")) << "no curve";
}

TEST(Ribbons, OfOneNameHaveOneEntryInTheLegend) {
  Curve one = curve_named("one", 1), other = curve_named("other", 2);
  for (Curve* curve : {&one, &other}) {
    curve->lower = curve->upper = curve->y;
    curve->ribbon = "95 % interval";
  }
  const std::string script = gnuplot_script(figure_of({one, other}));
  const auto first = script.find("title '95 % interval'");
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(script.find("title '95 % interval'", first + 1), std::string::npos);
}

TEST(GivenRange, IsTheAxis) {
  Figure figure = figure_of({curve_named("run", 5)});
  figure.y_range = {-2, 3};
  EXPECT_EQ(plot_ranges(figure).vertical.lower, -2);
  EXPECT_EQ(plot_ranges(figure).vertical.upper, 3);
}

}  // namespace
}  // namespace slosh::reports::figure_look_test
