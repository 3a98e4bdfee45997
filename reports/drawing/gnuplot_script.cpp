#include "reports/drawing/gnuplot_script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "reports/drawing/axes.hpp"
#include "reports/drawing/figure_palette.hpp"
#include "reports/drawing/run_gnuplot.hpp"

namespace slosh::reports {
namespace {

constexpr int plot_height =
    380;  // px, axis labels included, legend not: half the width, as a time history reads best
constexpr int square_plot_height = 560;  // px, as above, of a figure with equal axes
constexpr int axis_label_height =
    56;  // px, below the frame: ticks, numbers, label and a gap before the legend
constexpr int row_height =
    20;  // px, of a legend row and of a row of marker labels: gnuplot's line of the 13 px font
constexpr double character_width =
    8.5;  // px, of a 13 px sans-serif font, names with digits and underscores
constexpr double plot_width = 640;  // px, the canvas less its margins at their widest
constexpr double key_width =
    600;  // px, on the safe side: gnuplot uses fewer columns where it finds no room
constexpr double key_sample_width =
    55;                  // px, the line before a legend entry and the space after it
constexpr int foot = 8;  // px, below the legend: its descenders

// Returns each label once.
std::vector<std::string> span_labels(const Figure& figure) {
  std::vector<std::string> labels;
  for (const Span& span : figure.spans)
    if (std::find(labels.begin(), labels.end(), span.label) == labels.end())
      labels.push_back(span.label);
  return labels;
}

struct KeyLayout {
  int columns, rows;
  double narrower;  // characters to take off each entry: gnuplot assumes wide ones, 0.7 of the font
                    // size
};

KeyLayout key_layout(const Figure& figure) {
  double widest = 0;
  for (const Curve& curve : figure.curves)
    widest = std::max(widest, text_width(curve.label, character_width));
  for (const Band& band : figure.bands)
    widest = std::max(widest, text_width(band.label, character_width));
  const std::vector<std::string> spans = span_labels(figure);
  for (const std::string& label : spans)
    widest = std::max(widest, text_width(label, character_width));
  const int columns = std::max(1, static_cast<int>(key_width / (widest + key_sample_width)));
  const int entries = static_cast<int>(figure.curves.size() + figure.bands.size() + spans.size());
  const double reckoned_width = 0.7 * 13;
  return {columns, (entries + columns - 1) / columns,
          widest * (1 / character_width - 1 / reckoned_width)};
}

struct PlacedMarker {
  const Marker* marker;
  int row;  // of its label, counted upwards from the frame
};

// Puts each label in the lowest row above the frame in which it does not touch its left neighbour.
std::vector<PlacedMarker> placed_markers(const Figure& figure, const AxisRange& range) {
  std::vector<PlacedMarker> placed;
  for (const Marker& marker : figure.markers) {
    if (marker.x >= range.lower && marker.x <= range.upper) placed.push_back({&marker, 0});
  }
  std::stable_sort(placed.begin(), placed.end(), [](const PlacedMarker& a, const PlacedMarker& b) {
    return a.marker->x < b.marker->x;
  });
  const auto scale = [&](double x) { return figure.log_x ? std::log(x) : x; };
  std::vector<double> row_ends;
  for (PlacedMarker& label : placed) {
    const double centre = plot_width * (scale(label.marker->x) - scale(range.lower)) /
                          (scale(range.upper) - scale(range.lower));
    const double half = text_width(label.marker->label, character_width) / 2 + character_width / 2;
    const auto free_row = std::find_if(row_ends.begin(), row_ends.end(),
                                       [&](double end) { return end <= centre - half; });
    label.row = static_cast<int>(free_row - row_ends.begin());
    if (free_row == row_ends.end()) row_ends.push_back(0);
    row_ends[static_cast<std::size_t>(label.row)] = centre + half;
  }
  return placed;
}

int marker_rows(const std::vector<PlacedMarker>& placed) {
  int rows = 0;
  for (const PlacedMarker& label : placed) rows = std::max(rows, label.row + 1);
  return rows;
}

std::string terminal_command(Terminal terminal, int height) {
  if (terminal == Terminal::svg)
    return fmt::format("set terminal svg size {},{} dynamic enhanced font 'sans-serif,13'\n",
                       canvas_width, height);
  return fmt::format(
      "set terminal pngcairo size {},{} enhanced font 'sans-serif,10' fontscale 2 linewidth 2 "
      "pointscale 2 background rgb '{}'\n",
      2 * canvas_width, 2 * height, paper.light);
}

std::string canvas(const Figure& figure, Terminal terminal) {
  const KeyLayout key = key_layout(figure);
  const double height = canvas_height(figure);
  const double key_height = row_height * key.rows + foot;
  return fmt::format(
             "set encoding utf8\nset minussign\n{}"
             "set border 3 lc rgb '{}'\nset tics out nomirror scale 0.6 textcolor rgb '{}'\n"
             "set grid lt 1 lw 1 lc rgb '{}'\nset xzeroaxis lt 1 lw 1 lc rgb '{}'\n"
             "set bars 0.6\n"
             "set bmargin at screen {:.4f}\n"
             "set key at graph 0, screen {:.4f} left top horizontal maxcols {} width {:.2f} Left "
             "reverse "
             "samplen 3 spacing 1 noenhanced textcolor rgb '{}'\n"
             "set rmargin 3\n",
             terminal_command(terminal, canvas_height(figure)), ink.light, ink.light, grid.light,
             faint_ink.light, (axis_label_height + key_height) / height, key_height / height,
             key.columns, -key.narrower, ink.light) +
         (figure.equal_axes ? "set size square\n" : "");
}

std::string axis(char name, const std::string& label, const AxisRange& range, bool logarithmic) {
  // gnuplot's own logarithm may put a tick at the end of a logarithmic axis beyond it.
  const double slack = logarithmic ? 1e-9 : 0;
  std::string commands = fmt::format(
      "set {0}label {1} offset {5} noenhanced textcolor rgb '{2}'\nset {0}range "
      "[{3}:{4}]\n",
      name, quoted(label), ink.light, range.lower * (1 - slack), range.upper * (1 + slack),
      name == 'x' ? "0,0.4" : "0,0");
  if (logarithmic) {
    commands += fmt::format("set logscale {0}\nset {0}tics {1}\n", name, logarithmic_ticks(range));
  } else {
    commands += fmt::format("set format {} '%g'\n", name);
  }
  return commands;
}

std::string band_objects(const Figure& figure) {
  std::string commands;
  for (std::size_t i = 0; i < figure.bands.size(); ++i) {
    const Band& band = figure.bands[i];
    if (std::isnan(band.lower) || std::isnan(band.upper)) continue;
    const auto level = [&](double value, const char* edge) {
      return std::isfinite(value) && !(figure.log_y && value <= 0)
                 ? fmt::format("first {:.9g}", value)
                 : std::string(edge);
    };
    commands += fmt::format(
        "set object rectangle from graph 0, {} to graph 1, {} behind fc rgb '{}' fs transparent "
        "solid {} noborder\n",
        level(band.lower, "graph 0"), level(band.upper, "graph 1"),
        band_colours[i % band_colours.size()].light, band_opacity);
  }
  return commands;
}

std::string named_ticks(const Figure& figure) {
  if (figure.x_ticks.empty()) return "";
  std::vector<std::string> ticks;
  for (const auto& [place, label] : figure.x_ticks)
    ticks.push_back(fmt::format("{} {:.9g}", quoted(label), place));
  return fmt::format("set xtics noenhanced ({})\n", fmt::join(ticks, ", "));
}

std::string span_objects(const Figure& figure, const AxisRange& range) {
  std::string commands;
  for (const Span& span : figure.spans) {
    const double begin = std::max(span.begin, range.lower), end = std::min(span.end, range.upper);
    if (!(begin < end)) continue;
    commands += fmt::format(
        "set object rectangle from first {:.9g}, graph 0 to first {:.9g}, graph 1 behind fc rgb "
        "'{}' fs transparent solid {} noborder\n",
        begin, end, faint_ink.light, band_opacity);
  }
  return commands;
}

std::string marker_lines(const std::vector<PlacedMarker>& placed) {
  std::string commands = fmt::format("set tmargin {}\n", 1 + marker_rows(placed));
  for (const auto& [marker, row] : placed) {
    commands += fmt::format(
        "set arrow from first {0:.9g}, graph 0 to first {0:.9g}, graph 1 nohead lw 1.2 dt (4,3) lc "
        "rgb '{1}'\n"
        "set label {2} at first {0:.9g}, graph 1 center offset 0,{3:.1f} noenhanced textcolor rgb "
        "'{4}'\n",
        marker->x, faint_ink.light, quoted(marker->label), 0.6 + row, ink.light);
  }
  return commands;
}

// Writes one line per sample and one blank line per gap: two consecutive blank lines would end the
// data set.
std::string datablock(const Figure& figure, std::size_t number) {
  const Curve& curve = figure.curves[number];
  std::string block = fmt::format("$curve_{} << END_OF_CURVE\n", number);
  bool in_gap = true;
  for (const auto& index : drawn_samples(figure, curve, drawn_limit)) {
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

// Returns "", "x", "y" or "xy", with which gnuplot's styles of error bars begin.
std::string bar_directions(const Curve& curve) {
  return std::string(curve.x_error.empty() ? "" : "x") + (curve.y_error.empty() ? "" : "y");
}

// Writes the samples of which both edges are finite. On a logarithmic axis an edge that is not
// positive lies on the frame.
std::string ribbon_block(const Figure& figure, std::size_t number, const AxisRange& vertical) {
  const Curve& curve = figure.curves[number];
  std::string block = fmt::format("$ribbon_{} << END_OF_RIBBON\n", number);
  bool in_gap = true;
  for (const auto& index : drawn_samples(figure, curve, drawn_limit)) {
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

std::string ribbon_element(std::size_t number) {
  return fmt::format(
      "$ribbon_{} using 1:2:3 with filledcurves fc rgb '{}' fs transparent solid {} noborder "
      "notitle",
      number, curve_colours[number % curve_colours.size()].light, band_opacity);
}

// `of_style` is the number of earlier curves that share the curve's dashes.
std::string curve_element(const Curve& curve, std::size_t number, std::size_t of_style) {
  const std::string bars = bar_directions(curve);
  const std::string colour = curve_colours[number % curve_colours.size()].light;
  const int point = point_types[number % point_types.size()];
  const std::string marks = fmt::format("pt {} ps 0.7", point);
  const char* dash = curve.style == Curve::Style::dashed
                         ? dashed_dashes[of_style % dashed_dashes.size()]
                         : line_dashes[of_style % line_dashes.size()];
  std::string style;
  if (curve.style == Curve::Style::points) {
    style = fmt::format("{} {} lw 1.2", bars.empty() ? "points" : bars + "errorbars", marks);
  } else {
    const bool pointed = !bars.empty() || curve.style == Curve::Style::line_points;
    style = fmt::format("{} {} lw 1.8 dt {}",
                        !bars.empty() ? bars + "errorlines"
                        : pointed     ? "linespoints"
                                      : "lines",
                        pointed ? marks : "", dash);
  }
  return fmt::format("$curve_{} using 1:2{} with {} lc rgb '{}' title {}", number,
                     bars.empty()   ? ""
                     : bars == "xy" ? ":3:4"
                                    : ":3",
                     style, colour, quoted(curve.label));
}

std::string plot_command(const Figure& figure) {
  std::vector<std::string> elements;
  for (std::size_t i = 0; i < figure.curves.size(); ++i)
    if (!figure.curves[i].lower.empty()) elements.push_back(ribbon_element(i));
  std::array<std::size_t, 2> of_style{0, 0};
  for (std::size_t i = 0; i < figure.curves.size(); ++i) {
    const Curve& curve = figure.curves[i];
    const std::size_t group = curve.style == Curve::Style::dashed;
    const bool has_line = curve.style != Curve::Style::points;
    elements.push_back(curve_element(curve, i, of_style[group]));
    of_style[group] += has_line;
  }
  for (std::size_t i = 0; i < figure.bands.size(); ++i) {
    elements.push_back(fmt::format(
        "keyentry with boxes fc rgb '{}' fs transparent solid {} noborder title {}",
        band_colours[i % band_colours.size()].light, band_opacity, quoted(figure.bands[i].label)));
  }
  for (const std::string& label : span_labels(figure))
    elements.push_back(
        fmt::format("keyentry with boxes fc rgb '{}' fs transparent solid {} noborder title {}",
                    faint_ink.light, band_opacity, quoted(label)));
  if (elements.empty()) elements.push_back("NaN notitle");
  return fmt::format("plot {}\n", fmt::join(elements, ", \\\n  "));
}

}  // namespace

int canvas_height(const Figure& figure) {
  const int rows =
      key_layout(figure).rows + marker_rows(placed_markers(figure, plot_ranges(figure).horizontal));
  return (figure.equal_axes ? square_plot_height : plot_height) + row_height * rows;
}

std::string gnuplot_script(const Figure& figure, Terminal terminal) {
  const auto [horizontal, vertical] = plot_ranges(figure);
  std::string script = canvas(figure, terminal);
  script += axis('x', figure.x_label, horizontal, figure.log_x) + named_ticks(figure);
  script += axis('y', figure.y_label, vertical, figure.log_y);
  script += span_objects(figure, horizontal) + band_objects(figure);
  script += marker_lines(placed_markers(figure, horizontal));
  for (std::size_t i = 0; i < figure.curves.size(); ++i) {
    script += datablock(figure, i);
    if (!figure.curves[i].lower.empty()) script += ribbon_block(figure, i, vertical);
  }
  return script + plot_command(figure);
}

}  // namespace slosh::reports
