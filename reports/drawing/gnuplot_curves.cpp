#include "reports/drawing/gnuplot_curves.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "reports/drawing/figure_layout.hpp"
#include "reports/drawing/figure_palette.hpp"
#include "reports/drawing/run_gnuplot.hpp"

namespace slosh::reports {
namespace {

constexpr std::size_t marks_on_a_line = 9;  // about: they tell curves apart and hide none
constexpr double thin = 0.45;               // of the width of a curve that sets the scale

template <class List>
const auto& in_turn(const List& list, std::size_t number) {
  return list[number % list.size()];
}

// Many curves share what a figure may weigh.
std::size_t entries_of_a_curve(const Figure& figure) {
  const std::size_t share = all_drawn_limit / std::max<std::size_t>(1, figure.curves.size());
  return std::clamp<std::size_t>(share, 5, drawn_limit);
}

// Writes one line per sample and one blank line per gap: two consecutive blank lines would end the
// data set.
std::string datablock(const Figure& figure, std::size_t number) {
  const Curve& curve = figure.curves[number];
  std::string block = fmt::format("$curve_{} << END_OF_CURVE\n", number);
  bool in_gap = true;
  for (const auto& index : drawn_samples(figure, curve, entries_of_a_curve(figure))) {
    if (!index) {
      if (!in_gap) block += '\n';
    } else {
      block += fmt::format("{:.9g} {:.9g}", curve.x[*index], curve.y[*index]);
      for (const auto* bars : {&curve.x_error, &curve.y_error})
        if (!bars->empty()) block += fmt::format(" {:.9g}", (*bars)[*index]);
      block += '\n';
    }
    in_gap = !index;
  }
  return block + "END_OF_CURVE\n";
}

// Writes the samples of which both edges are finite. On a logarithmic axis an edge that is not
// positive lies on the frame.
std::string ribbon_block(const Figure& figure, std::size_t number, const AxisRange& vertical) {
  const Curve& curve = figure.curves[number];
  std::string block = fmt::format("$ribbon_{} << END_OF_RIBBON\n", number);
  bool in_gap = true;
  for (const auto& index : drawn_samples(figure, curve, entries_of_a_curve(figure))) {
    const bool drawn =
        index && std::isfinite(curve.lower[*index]) && std::isfinite(curve.upper[*index]);
    if (drawn) {
      const double lower =
          figure.log_y ? std::max(curve.lower[*index], vertical.lower) : curve.lower[*index];
      block += fmt::format("{:.9g} {:.9g} {:.9g}\n", curve.x[*index], lower,
                           std::max(lower, curve.upper[*index]));
    } else if (!in_gap) {
      block += '\n';
    }
    in_gap = !drawn;
  }
  return block + "END_OF_RIBBON\n";
}

// The strokes of all curves. A curve without a look has the hue and the marker of its place in the
// figure, and the dash of its place among the lines of its style.
std::vector<Stroke> strokes_of(const Figure& figure) {
  std::vector<Stroke> strokes;
  std::array<std::size_t, 2> of_style{0, 0};
  for (std::size_t i = 0; i < figure.curves.size(); ++i) {
    const Curve& curve = figure.curves[i];
    const bool dashed = curve.style == Curve::Style::dashed;
    strokes.push_back(stroke_of(curve.look.value_or(Look{false, i, of_style[dashed]}), dashed));
    if (curve.look) continue;
    strokes.back().point = in_turn(point_types, i);
    of_style[dashed] += curve.style != Curve::Style::points;
  }
  return strokes;
}

std::string filled(const char* colour) {
  return fmt::format("fc rgb '{}' fs transparent solid {} noborder", colour, band_opacity);
}

// Returns "", "x", "y" or "xy", with which gnuplot's styles of error bars begin.
std::string bar_directions(const Curve& curve) {
  return std::string(curve.x_error.empty() ? "" : "x") + (curve.y_error.empty() ? "" : "y");
}

// A long line of a run has a few of the run's markers; a reference's line has none, and neither has
// a level of few samples, on which they would look like data.
std::string marks_on(const Figure& figure, const Curve& curve, int point) {
  if (!curve.look || curve.look->is_reference || figure.is_small || !curve.sets_scale) return "";
  const std::size_t drawn = std::min(curve.x.size(), entries_of_a_curve(figure));
  if (drawn < marks_on_a_line) return "";
  // The intervals differ, so that the markers of equal curves do not hide one another.
  const std::size_t interval = drawn / (marks_on_a_line + curve.look->colour) + 1;
  return fmt::format("pt {} ps 0.7 pi {}", point, interval);
}

std::string style_text(const Figure& figure, const Curve& curve, const Stroke& stroke) {
  const std::string bars = bar_directions(curve), marks = fmt::format("pt {} ps 0.7", stroke.point);
  if (curve.style == Curve::Style::points)
    return fmt::format("{} {} lw 1.2", bars.empty() ? "points" : bars + "errorbars", marks);
  const bool pointed = !bars.empty() || curve.style == Curve::Style::line_points;
  const std::string some = pointed ? marks : marks_on(figure, curve, stroke.point);
  return fmt::format("{} {} lw {} dt {}",
                     !bars.empty()  ? bars + "errorlines"
                     : some.empty() ? "lines"
                                    : "linespoints",
                     some, canvas_of(figure).line_width * (curve.sets_scale ? 1 : thin),
                     stroke.dash);
}

// Returns the title of a plot element, and an element without a symbol for each further line.
std::string titled(const std::string& label) {
  if (label.empty()) return "notitle";
  std::vector<std::string> titles;
  for (const std::string& line : legend_lines(label)) titles.push_back("title " + quoted(line));
  return fmt::format("{}", fmt::join(titles, ", \\\n  keyentry with lines lt nodraw "));
}

std::string curve_element(const Figure& figure, std::size_t number, const Stroke& stroke) {
  const Curve& curve = figure.curves[number];
  const std::string bars = bar_directions(curve);
  return fmt::format("$curve_{} using 1:2{} with {} lc rgb '{}' {}", number,
                     bars.empty()   ? ""
                     : bars == "xy" ? ":3:4"
                                    : ":3",
                     style_text(figure, curve, stroke), stroke.colour, titled(curve.label));
}

// The legend's entry of a ribbon has the colour of the first curve that has one.
std::string ribbon_entry(const Figure& figure, const std::string& label,
                         const std::vector<Stroke>& strokes) {
  const auto first = std::find_if(figure.curves.begin(), figure.curves.end(),
                                  [&](const Curve& curve) { return curve.ribbon == label; });
  return fmt::format(
      "keyentry with boxes {} {}",
      filled(strokes[static_cast<std::size_t>(first - figure.curves.begin())].colour),
      titled(label));
}

}  // namespace

Stroke stroke_of(const Look& look, bool dashed) {
  const PaletteColour& colour =
      look.is_reference ? in_turn(reference_colours, look.colour) : in_turn(hues, look.colour);
  return {colour.light, in_turn(look.is_reference ? reference_points : point_types, look.shape),
          in_turn(dashed ? dashed_dashes : line_dashes, look.shape)};
}

const char* band_colour(const Figure& figure, std::size_t index) {
  const std::optional<Look>& look = figure.bands[index].look;
  return look ? stroke_of(*look).colour : in_turn(band_colours, index).light;
}

std::string curve_data(const Figure& figure, const AxisRange& vertical) {
  std::string blocks;
  for (std::size_t i = 0; i < figure.curves.size(); ++i) {
    blocks += datablock(figure, i);
    if (!figure.curves[i].lower.empty()) blocks += ribbon_block(figure, i, vertical);
  }
  return blocks;
}

std::string plot_command(const Figure& figure) {
  const std::vector<Stroke> strokes = strokes_of(figure);
  std::vector<std::string> elements;
  for (std::size_t i = 0; i < figure.curves.size(); ++i)
    if (!figure.curves[i].lower.empty())
      elements.push_back(fmt::format("$ribbon_{} using 1:2:3 with filledcurves {} notitle", i,
                                     filled(strokes[i].colour)));
  for (std::size_t i = 0; i < figure.curves.size(); ++i)
    elements.push_back(curve_element(figure, i, strokes[i]));
  for (const std::string& label : ribbon_labels(figure))
    elements.push_back(ribbon_entry(figure, label, strokes));
  for (std::size_t i = 0; i < figure.bands.size(); ++i)
    elements.push_back(fmt::format("keyentry with boxes {} {}", filled(band_colour(figure, i)),
                                   titled(figure.bands[i].label)));
  for (const std::string& label : span_labels(figure))
    elements.push_back(
        fmt::format("keyentry with boxes {} {}", filled(faint_ink.light), titled(label)));
  if (elements.empty()) elements.push_back("NaN notitle");
  return fmt::format("plot {}\n", fmt::join(elements, ", \\\n  "));
}

}  // namespace slosh::reports
