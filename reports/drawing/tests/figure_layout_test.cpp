// Which samples of a curve are drawn, over which ranges, and how a figure draws curves that have a
// look, that set no scale, or that stand in a small figure.
#include "reports/drawing/figure_layout.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/drawing/draw_figure.hpp"
#include "reports/drawing/gnuplot_script.hpp"
#include "reports/tests/test_environment.hpp"
#include "verification/tests/messages.hpp"

namespace slosh::reports::figure_layout_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Figure figure_through(std::vector<double> x, std::vector<double> y) {
  Figure figure;
  figure.curves.push_back({"curve", std::move(x), std::move(y), {}});
  return figure;
}

Curve long_curve(std::size_t samples) {
  Curve curve;
  for (std::size_t i = 0; i < samples; ++i) {
    curve.x.push_back(static_cast<double>(i));
    curve.y.push_back(std::sin(0.01 * static_cast<double>(i)));
  }
  return curve;
}

TEST(DrawnSamples, OfAShortCurveAreAllThatItsAxesCanShow) {
  Figure figure = figure_through({1, 2, 3}, {1, -1, infinity});
  using Samples = std::vector<std::optional<std::size_t>>;
  EXPECT_EQ(drawn_samples(figure, figure.curves[0], 1500), (Samples{0, 1, std::nullopt}));
  figure.log_y = true;
  EXPECT_EQ(drawn_samples(figure, figure.curves[0], 1500),
            (Samples{0, std::nullopt, std::nullopt}));
  EXPECT_TRUE(drawn_samples(Figure{}, Curve{}, 1500).empty());
}

TEST(DrawnSamples, OfALongCurveKeepItsExtremesEndsAndGapsWithinTheLimit) {
  Curve curve = long_curve(100'000);
  curve.y[31'417] = 5.0;  // spikes of one sample
  curve.y[77'777] = -7.0;
  curve.y[50'000] = nan;
  const auto drawn = drawn_samples(Figure{}, curve, 1500);
  EXPECT_LE(drawn.size(), 1500u);
  EXPECT_GT(drawn.size(), 900u);
  EXPECT_EQ(std::count(drawn.begin(), drawn.end(), std::nullopt), 1);
  for (const std::size_t kept : {0, 31'417, 77'777, 99'999})
    EXPECT_EQ(std::count(drawn.begin(), drawn.end(), std::optional(kept)), 1) << kept;
  std::optional<std::size_t> last;
  for (const auto& sample : drawn) {
    if (!sample) continue;
    EXPECT_TRUE(!last || *last <= *sample);
    last = sample;
  }
}

TEST(AxisRanges, HoldTheDataAndIgnoreWhatIsNotFinite) {
  const auto [x, y] = plot_ranges(figure_through({0, 1, nan, 3, 4}, {-2, infinity, 9, 5, nan}));
  EXPECT_EQ(x.lower, 0);
  EXPECT_EQ(x.upper, 3);
  EXPECT_LT(y.lower, -2);
  EXPECT_GT(y.upper, 5);
  EXPECT_LT(y.upper, 6);
}

TEST(AxisRanges, HoldBandsMarkersAndErrorBars) {
  Figure figure = figure_through({0, 1}, {0, 1});
  figure.curves[0].y_error = {3, 0};
  figure.bands = {{"tolerance", -infinity, 8}};
  figure.markers = {{"predicted", 2}};
  const auto [x, y] = plot_ranges(figure);
  EXPECT_GE(x.upper, 2);
  EXPECT_GT(y.upper, 8);
  EXPECT_LT(y.lower, -3);
}

TEST(AxisRanges, HoldHorizontalErrorBarsOnEitherKindOfAxis) {
  Figure figure = figure_through({10, 100, 200}, {1, 2, 3});
  figure.curves[0].x_error = {2, 300, nan};
  EXPECT_GT(plot_ranges(figure).horizontal.upper, 400);
  EXPECT_LT(plot_ranges(figure).horizontal.lower, -200);
  figure.log_x = true;  // a bar that reaches below zero sets no end there
  EXPECT_GE(plot_ranges(figure).horizontal.upper, 400);
  EXPECT_EQ(plot_ranges(figure).horizontal.lower, 5);
}

TEST(AxisRanges, AreThoseGivenAndScaledToWhatIsInsideThem) {
  Figure figure = figure_through({0, 1, 2}, {0, 1, 1000});
  figure.x_range = {0, 1.5};
  EXPECT_EQ(plot_ranges(figure).horizontal.upper, 1.5);
  EXPECT_LT(plot_ranges(figure).vertical.upper, 2);
  figure.y_range = {-2, 3};
  EXPECT_EQ(plot_ranges(figure).vertical.lower, -2);
  EXPECT_EQ(plot_ranges(figure).vertical.upper, 3);
}

TEST(AxisRanges, AreNeverEmpty) {
  for (const bool logarithmic : {false, true})
    for (const auto& y :
         {std::vector<double>{nan, nan}, std::vector<double>{3, 3}, std::vector<double>{0, 0}}) {
      Figure figure = figure_through({1, 1}, y);
      figure.log_x = figure.log_y = logarithmic;
      const auto [horizontal, vertical] = plot_ranges(figure);
      EXPECT_LT(horizontal.lower, horizontal.upper);
      EXPECT_LT(vertical.lower, vertical.upper);
      EXPECT_TRUE(!logarithmic || vertical.lower > 0);
    }
}

TEST(LogarithmicTicks, NameOneTwoAndFiveOverFewDecadesAndPowersOfTenOverMany) {
  const std::string ticks = logarithmic_ticks({2, 50}), many = logarithmic_ticks({1e-12, 1e3}),
                    most = logarithmic_ticks({1e-200, 1e250});  // the quotient overflows
  for (const char* tick : {"'2' 2", "'5' 5", "'10' 10", "'20' 20", "'50' 50"})
    EXPECT_TRUE(holds(ticks, tick));
  EXPECT_TRUE(holds(many, "'10^{-12}'"));
  EXPECT_LE(std::count(many.begin(), many.end(), ','), 8);
  EXPECT_LE(std::count(most.begin(), most.end(), ','), 9) << most;
}

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

TEST(Look, OfAReferenceIsBlackOrGreyAndHasNoMarkersNorHasALevel) {
  Curve theory = curve_named("theory", 1), record = theory;
  theory.look = Look{true, 0, 0};
  record.look = Look{true, 1, 0};
  record.label = "record";
  Curve level{"level", {0, 1}, {1, 1}, {}, Curve::Style::line};
  level.look = Look{false, 0, 0};  // markers at its two ends would look like data
  const Figure figure = figure_of({theory, record, level});
  EXPECT_TRUE(holds(element(figure, "theory"), "#1f2933"));
  EXPECT_TRUE(holds(element(figure, "record"), "#67727e"));
  for (const char* line : {"theory", "level"}) EXPECT_FALSE(holds(element(figure, line), " pt "));
}

TEST(Look, OfABandIsTheColourOfItsCurve) {
  Figure figure = figure_of({curve_named("run", 1)});
  figure.bands = {{"of the run", -1, 1, Look{false, 4, 0}}, {"of none", -2, 2}};
  const std::string script = gnuplot_script(figure), run = stroke_of({false, 4, 0}).colour;
  const std::size_t rectangle = script.find("set object rectangle");
  EXPECT_EQ(script.find("fc rgb '" + run, rectangle), script.find("fc rgb '", rectangle));
  EXPECT_NE(band_colour(figure, 1), run);
}

TEST(Look, IsAnotherForEachRunOfAFamilyOfFour) {
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Stroke one = stroke_of({false, 0, i}), other = stroke_of({false, 0, j});
      EXPECT_NE(one.point, other.point);
      EXPECT_STRNE(one.dash, other.dash);
    }
}

TEST(CurveWithoutScale, IsThinAndLeavesTheAxisToTheOthersWithItsBand) {
  Curve far = curve_named("far", 1000);
  far.look = Look{false, 3, 0};
  far.x.back() = 500;
  Figure both = figure_of({curve_named("near", 1), far});
  both.bands = {{"tolerance", -600, 600, far.look}};
  EXPECT_GT(plot_ranges(both).vertical.upper, 1000);
  Figure cut = both;
  cut.curves[1].sets_scale = false;
  EXPECT_EQ(plot_ranges(cut).vertical.upper,
            plot_ranges(figure_of({curve_named("near", 1)})).vertical.upper);
  EXPECT_TRUE(holds(element(both, "far"), "lw 1.8"));
  EXPECT_TRUE(holds(element(cut, "far"), "lw 0.81")) << element(cut, "far");
  cut.equal_axes = true;
  EXPECT_LT(plot_ranges(cut).horizontal.upper, 200);
  cut.curves.erase(cut.curves.begin());
  EXPECT_GT(plot_ranges(cut).vertical.upper, 1000) << "there is nothing else to see";
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

}  // namespace
}  // namespace slosh::reports::figure_layout_test
