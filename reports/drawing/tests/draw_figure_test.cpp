#include "reports/drawing/draw_figure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/property_tree/xml_parser.hpp>
#include <fstream>
#include <limits>
#include <regex>
#include <set>
#include <sstream>

#include "reports/drawing/figure_layout.hpp"
#include "reports/drawing/gnuplot_script.hpp"
#include "reports/pages/report_documents.hpp"
#include "reports/pages/write_report.hpp"
#include "reports/tests/test_environment.hpp"
#include "verification/tests/messages.hpp"

namespace slosh::reports::draw_figure_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();

Figure simple_figure(const std::string& id, std::vector<double> y) {
  Figure figure;
  figure.id = id;
  figure.title = "title";
  Curve curve{.label = "curve", .x = {}, .y = std::move(y), .y_error = {}};
  for (std::size_t i = 0; i < curve.y.size(); ++i) curve.x.push_back(static_cast<double>(i));
  figure.curves = {curve};
  return figure;
}

std::string drawn_markup(const Figure& figure) {
  const ScratchDirectory scratch;
  return draw_figure(figure, scratch.path()).markup;
}

std::string drawn_file(const Figure& figure) {
  const ScratchDirectory scratch;
  return svg_element(figure, draw_figure(figure, scratch.path()), SvgPlace::own_file);
}

long occurrences(const std::string& text, const std::string& part) {
  long count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

// A program of that name in the directory.
void write_gnuplot(const ScratchDirectory& scratch, const std::string& script) {
  std::ofstream(scratch / "gnuplot") << "#!/bin/sh\n" << script;
  std::filesystem::permissions(scratch / "gnuplot", std::filesystem::perms::owner_all);
}

// Returns the path data of the first curve, of which the first stroke is the legend's.
std::string curve_path(const std::string& markup) {
  const auto curve = markup.find("gnuplot_plot_1");
  const auto start = markup.find(" d='", markup.find("#0069a8", curve)) + 4;
  return markup.substr(start, markup.find('\'', start) - start);
}

void expect_well_formed(const std::string& svg) {
  std::istringstream stream(svg);
  boost::property_tree::ptree tree;
  EXPECT_NO_THROW(boost::property_tree::read_xml(stream, tree)) << svg.substr(0, 500);
}

TEST(DrawnFigure, IsAPngFileToo) {
  const ScratchDirectory scratch;
  const std::string png = draw_png(simple_figure("pixels", {1, 2, 3}), scratch.path());
  EXPECT_TRUE(begins(png, "\x89PNG"));
  EXPECT_GT(png.size(), 5000u) << "an empty picture";
}

TEST(FigurePage, HoldsItsFiguresAndRemarksWithEveryLetterEscaped) {
  const ScratchDirectory scratch;
  Figure figure = simple_figure("only", {1, 2, 3});
  figure.caption = "a < b";
  const std::string page = figure_page("This & that", {figure}, {"<b> is missing"}, scratch.path());
  for (const char* part : {"<h1>This &amp; that</h1>", "<svg ", "plot-only-title", "a &lt; b",
                           "<p>&lt;b&gt; is missing</p>"})
    EXPECT_TRUE(holds(page, part));
}

TEST(DrawnFigure, BreaksTheLineAtValuesThatAreNotFinite) {
  const auto strokes = [](std::vector<double> y) {
    const std::string path = curve_path(drawn_markup(simple_figure("gap", std::move(y))));
    return std::count(path.begin(), path.end(), 'M') - 1;  // less the legend's
  };
  EXPECT_EQ(strokes({1, 2, 3, 4, 5, 6}), 1);
  EXPECT_EQ(strokes({1, 2, nan, 4, 5, 6}), 2);
  EXPECT_EQ(strokes({1, 2, nan, nan, 5, 6}), 2);
  EXPECT_EQ(strokes({nan, 1, 2, 3, 4, infinity}), 1);
}

TEST(DrawnFigure, HasIdsOfItsOwnAndRefersOnlyToThem) {
  Figure figure = simple_figure("wave-1", {1, 2, 3});
  figure.curves[0].style = Curve::Style::line_points;
  const std::string markup = drawn_markup(figure);
  std::set<std::string> ids;
  const std::regex id(R"( id=["']([^"']*)["'])"), reference(R"(href=["']#([^"']*)["'])");
  for (std::sregex_iterator match(markup.begin(), markup.end(), id), end; match != end; ++match) {
    EXPECT_EQ((*match)[1].str().rfind("plot-wave-1-", 0), 0u) << (*match)[1];
    EXPECT_TRUE(ids.insert((*match)[1]).second) << (*match)[1] << " twice";
  }
  EXPECT_FALSE(ids.empty());
  int references = 0;
  for (std::sregex_iterator match(markup.begin(), markup.end(), reference), end; match != end;
       ++match, ++references) {
    EXPECT_TRUE(ids.contains((*match)[1])) << (*match)[1];
  }
  EXPECT_GE(references, 3);  // a symbol a sample
}

TEST(DrawnFigure, CarriesOnlyColoursThatTheDarkSchemeRepaints) {
  Figure figure = simple_figure("colours", {1, 2, 3});
  figure.curves.push_back({"bars", {0, 1}, {1, 2}, {0.1, 0.2}, Curve::Style::points});
  figure.bands = {{"band", 1, 2}};
  figure.markers = {{"marker", 1}};
  const std::string svg = drawn_file(figure);
  const std::regex colour(R"re((fill|stroke|color)\s*=\s*["']([^"']*)["'])re");
  for (std::sregex_iterator match(svg.begin(), svg.end(), colour), end; match != end; ++match) {
    const std::string property = (*match)[1], value = (*match)[2];
    if (value == "none" || value == "currentColor") continue;
    const std::string rule = ".plot [" + property + "=\"" + value + "\"]";
    EXPECT_TRUE(holds(svg, rule)) << match->str();
  }
}

TEST(DrawnFigure, ShowsLabelsAsTheyAreAndRunsNothingInThem) {
  const ScratchDirectory scratch;
  const auto trap = scratch / "trap";
  Figure figure = simple_figure("labels", {1, 2, 3});
  figure.curves[0].label =
      "it's `touch " + trap.string() + "` @x \"black\" 'black' <b> & {a}_b^c\n\x01";
  figure.x_label = figure.curves[0].label;
  figure.y_label = "''s axis' begins with apostrophes";
  figure.markers = {{figure.curves[0].label, 1}};
  figure.bands = {{figure.curves[0].label, 1, 2}};
  const std::string svg = drawn_file(figure);
  EXPECT_FALSE(std::filesystem::exists(trap));
  EXPECT_TRUE(holds(svg, "@x \"black\" 'black' &lt;b"));
  EXPECT_TRUE(holds(svg, "{a}_b^c"));
  EXPECT_TRUE(holds(svg, figure.y_label));
  expect_well_formed(svg);
}

TEST(DrawnFigure, LabelsBothEndsOfALogarithmicAxis) {
  for (const double lower : {0.001, 0.01, 0.1, 1.0, 10.0, 1000.0}) {
    Figure figure = simple_figure("ends", {1, 2});
    figure.curves[0].x = {1.3 * lower, 4 * lower};
    figure.log_x = true;
    const std::string markup = drawn_markup(figure);
    for (const double end : {lower, 5 * lower}) {
      std::ostringstream label;
      label << '>' << end << '<';
      EXPECT_TRUE(holds(markup, label.str()));
    }
  }
}

// gnuplot draws an error bar as a line and two ends, all of them horizontal or vertical strokes.
TEST(DrawnFigure, DrawsBarsInTheDirectionsThatItHasThemIn) {
  const auto strokes = [](std::vector<double> x_error, std::vector<double> y_error) {
    Figure figure = simple_figure("bars", {1, 4, 2});
    figure.curves[0].style = Curve::Style::points;
    figure.curves[0].x_error = std::move(x_error);
    figure.curves[0].y_error = std::move(y_error);
    const std::string path = curve_path(drawn_markup(figure));
    return std::count(path.begin(), path.end(), 'M');
  };
  const std::vector<double> bars{0.1, 0.2, 0.1}, one_unknown{0.1, nan, 0.1};
  const auto both = strokes(bars, bars), across = strokes(bars, {}), up = strokes({}, bars);
  EXPECT_GT(across, 3);
  EXPECT_GT(up, 3);
  EXPECT_GT(both, std::max(across, up));
  EXPECT_LT(strokes(one_unknown, bars), both);
}

TEST(DrawnFigure, OfEveryKindIsAWellFormedFile) {
  for (const bool logarithmic : {false, true}) {
    Figure figure = simple_figure("kinds", {1, 2, nan, 3000, -5});
    figure.log_x = figure.log_y = logarithmic;
    figure.x_range = {1, 4};
    const std::vector<double> ends{1, 2, 3}, bars{1, nan, 4}, level{0.1, nan, 4};
    for (const auto style : {Curve::Style::dashed, Curve::Style::points, Curve::Style::line_points})
      for (const auto& [up, across] : {std::pair<std::vector<double>, std::vector<double>>{},
                                       {bars, {}},
                                       {{}, level},
                                       {bars, level}})
        figure.curves.push_back({"s", ends, ends, up, style, across});
    figure.bands = {{"lower", -infinity, 2}, {"undefined", nan, nan}};
    figure.markers = {{"a", 2}, {"outside", 9}, {"undefined", nan}};
    expect_well_formed(drawn_file(figure));
  }
}

TEST(DrawnFigure, SurvivesValuesThatAreNearlyEqualHugeTinyOrNone) {
  for (const bool logarithmic : {false, true})
    for (const auto& y : std::vector<std::vector<double>>{{1000, 1000 + 1e-9},
                                                          {1, 1.7e308, -1.7e308},
                                                          {1e-320, 1e-200, 1e250},
                                                          {0, 1e-320},
                                                          {nan, nan},
                                                          {}}) {
      Figure figure = simple_figure("extreme", y);
      figure.log_y = logarithmic;
      if (y.size() > 0 && y[0] == y[0]) figure.bands = {{"huge", -1.7e308, 1.7e308}};
      EXPECT_TRUE(holds(drawn_markup(figure), "<path")) << testing::PrintToString(y);
    }
  Figure no_curves = simple_figure("no-curves", {});
  no_curves.curves.clear();
  EXPECT_TRUE(holds(drawn_markup(no_curves), "<path"));
}

TEST(DrawnFigure, HasARibbonOnePieceForEachPartBetweenGaps) {
  const auto pieces = [](const std::vector<double>& upper) {
    Figure figure = simple_figure("ribbon", {1, 2, 3, 4, 5, 6});
    figure.curves[0].lower = {0, 1, 2, 3, 4, 5};
    figure.curves[0].upper = upper;
    return occurrences(drawn_markup(figure), "fill = '#0069a8'");
  };
  EXPECT_EQ(pieces({2, 3, 4, 5, 6, 7}), 1);
  EXPECT_EQ(pieces({2, 3, 4, nan, 6, 7}), 2);
  EXPECT_EQ(pieces({nan, nan, nan, nan, nan, nan}), 0);
  Figure deep = simple_figure("deep", {1, 2, 3});  // below a logarithmic axis it is cut
  deep.log_y = true;
  deep.curves[0].lower = {0.5, -1, 1};
  deep.curves[0].upper = {2, 3, 4};
  EXPECT_TRUE(holds(drawn_markup(deep), "fill = '#0069a8'"));
}

TEST(DrawnFigure, NamesSpansOfOneLabelOnceAndLeavesOutThoseBesideTheAxis) {
  Figure figure = simple_figure("spans", {1, 2, 3, 4, 5});
  const int without = canvas_height(figure);
  figure.x_range = {0, 4};
  figure.spans = {{"start", -1, 1}, {"start", 3, 9}, {"start", 5, 6}, {"start", 2, 2}};
  const std::string script = gnuplot_script(figure);
  EXPECT_EQ(occurrences(script, "title 'start'"), 1);
  EXPECT_EQ(occurrences(script, "set object"), 2);
  EXPECT_TRUE(holds(script, "from first 0, graph 0 to first 1, graph 1"));
  EXPECT_EQ(canvas_height(figure), without);  // beside the curve in one row of the legend
  const std::string svg = drawn_file(figure);
  EXPECT_TRUE(holds(svg, "start from 3 to 9 (shaded)"));
  expect_well_formed(svg);
}

TEST(DrawnFigure, BreaksALongEntryOfTheLegendAtACommaAndShowsAllOfIt) {
  Figure figure = simple_figure("legend", {1, 2, 3});
  const int of_one_line = canvas_height(figure);
  figure.curves[0].label =
      "recommended, quintic_spline, initial_state = settled, smoothing_length_ratio = 1.42, "
      "start_disorder = 0.2";
  EXPECT_EQ(canvas_height(figure), of_one_line + legend_row_height);
  const std::string markup = drawn_markup(figure);
  EXPECT_TRUE(holds(markup, ">recommended, quintic_spline, initial_state = settled,<"));
  EXPECT_TRUE(holds(markup, ">smoothing_length_ratio = 1.42, start_disorder = 0.2<"));
}

TEST(DrawnFigure, OfEqualAxesIsASquareOfOneScale) {
  Figure figure = simple_figure("square", {1, 1.1});
  figure.curves[0].x_error = {0.5, 0.5};
  figure.curves[0].y_error = {0.1, 0.1};
  figure.curves[0].style = Curve::Style::points;
  figure.equal_axes = true;
  // gnuplot writes the frame's axes as left top, left bottom, right bottom.
  const std::regex frame("M([0-9.]+),([0-9.]+) L([0-9.]+),([0-9.]+) L([0-9.]+),([0-9.]+) ");
  const std::string markup = drawn_markup(figure);
  double side = 0;
  for (std::sregex_iterator match(markup.begin(), markup.end(), frame), end; match != end; ++match)
    if ((*match)[1] == (*match)[3] && (*match)[4] == (*match)[6]) {
      side = std::stod((*match)[4]) - std::stod((*match)[2]);
      EXPECT_NEAR(std::stod((*match)[5]) - std::stod((*match)[3]), side, 0.2);
    }
  EXPECT_GT(side, 300);
  const auto [horizontal, vertical] = plot_ranges(figure);
  EXPECT_NEAR(horizontal.upper - horizontal.lower, vertical.upper - vertical.lower, 1e-12);
  EXPECT_LT(horizontal.lower, -0.5);  // with the bars
}

TEST(DrawnFigure, HasTheTicksThatItIsGiven) {
  Figure figure = simple_figure("ticks", {1, 2});
  figure.x_ticks = {{0, "first's"}, {1, "now"}};
  const std::string markup = drawn_markup(figure);
  EXPECT_TRUE(holds(markup, "first's"));
  EXPECT_TRUE(holds(markup, "now"));
  EXPECT_FALSE(holds(markup, ">0.5<"));
}

TEST(DrawnFigure, OfALongSeriesStaysSmall) {
  Figure figure = simple_figure("long", std::vector<double>(200'000, 0.0));
  for (std::size_t i = 0; i < figure.curves[0].y.size(); ++i)
    figure.curves[0].y[i] = static_cast<double>(i % 7919);
  EXPECT_LT(drawn_markup(figure).size(), 60'000u);
}

TEST(FailingGnuplot, IsAnErrorWithItsOwnWordsOrSaysWhatToInstall) {
  const ScratchDirectory scratch;
  const PathVariable path(scratch.path().string());
  const auto error = [&] {
    return message_of<ReportError>([&] {
      draw_figure(simple_figure("a", {1, 2}), scratch.path());
    });
  };
  EXPECT_TRUE(holds(error(), "gnuplot-nox"));
  for (const auto& [script, expected] :
       {std::pair{"echo 'no such terminal' >&2\nexit 3\n", "status 3: no such terminal"},
        {"exit 0\n", "not a complete SVG"},
        {"echo \"<svg><g id=\\\"gnuplot_canvas\\\"><path d='M 1,2 </svg>\"\n", "figure 'a'"}}) {
    write_gnuplot(scratch, script);
    EXPECT_TRUE(holds(error(), expected));
  }
}

TEST(EndlessGnuplot, IsEndedAtItsTimeLimitWithItsOwnWords) {
  const ScratchDirectory scratch;
  write_gnuplot(scratch, "echo drawing >&2\nexec sleep 60\n");
  const PathVariable path(scratch.path().string() + ":/usr/bin:/bin");
  EXPECT_EQ(message_of<ReportError>([&] { run_gnuplot_within(0.3, "", "a", scratch.path()); }),
            "figure 'a': gnuplot was ended at its time limit of 0.3 s: drawing\n");
}

}  // namespace
}  // namespace slosh::reports::draw_figure_test
