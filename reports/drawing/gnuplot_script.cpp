#include "reports/drawing/gnuplot_script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/drawing/axes.hpp"
#include "reports/drawing/figure_layout.hpp"
#include "reports/drawing/figure_palette.hpp"
#include "reports/drawing/gnuplot_curves.hpp"
#include "reports/drawing/run_gnuplot.hpp"

namespace slosh::reports {
namespace {

std::string terminal_command(const Canvas& canvas, int height, Terminal terminal) {
  if (terminal == Terminal::svg)
    return fmt::format("set terminal svg size {},{} dynamic enhanced font 'sans-serif,{}'\n",
                       canvas.width, height, canvas.font_size);
  // Its fonts are in points: 10 of them stand for 13 px.
  return fmt::format(
      "set terminal pngcairo size {},{} enhanced font 'sans-serif,{}' fontscale 2 linewidth 2 "
      "pointscale 2 background rgb '{}'\n",
      2 * canvas.width, 2 * height, canvas.font_size * 10 / 13, paper.light);
}

std::string key_command(const Figure& figure, double top) {
  if (figure.is_small) return "set key off\n";
  const KeyLayout key = key_layout(figure);
  return fmt::format(
      "set key at graph 0, screen {:.4f} left top horizontal maxcols {} width {:.2f} Left reverse "
      "samplen 3 spacing 1 noenhanced textcolor rgb '{}'\n",
      top, key.columns, -key.narrower, ink.light);
}

std::string canvas_commands(const Figure& figure, Terminal terminal) {
  const Canvas canvas = canvas_of(figure);
  const double height = canvas_height(figure);
  const double below = legend_height(figure);
  return fmt::format(
             "set encoding utf8\nset minussign\n{}"
             "set border 3 lc rgb '{}'\nset tics out nomirror scale 0.6 textcolor rgb '{}'\n"
             "set grid lt 1 lw 1 lc rgb '{}'\nset xzeroaxis lt 1 lw 1 lc rgb '{}'\n"
             "set bars 0.6\n"
             "set bmargin at screen {:.4f}\n{}"
             "set rmargin 3\n",
             terminal_command(canvas, canvas_height(figure), terminal), ink.light, ink.light,
             grid.light, faint_ink.light, (canvas.below_frame + below) / height,
             key_command(figure, below / height)) +
         (figure.equal_axes ? "set size square\n"
          : figure.to_scale ? "set size ratio -1\n"
                            : "");
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
        level(band.lower, "graph 0"), level(band.upper, "graph 1"), band_colour(figure, i),
        band_opacity);
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

}  // namespace

std::string gnuplot_script(const Figure& figure, Terminal terminal) {
  const auto [horizontal, vertical] = plot_ranges(figure);
  std::string script = canvas_commands(figure, terminal);
  script += axis('x', figure.x_label, horizontal, figure.log_x) + named_ticks(figure);
  script += axis('y', figure.y_label, vertical, figure.log_y);
  script += span_objects(figure, horizontal) + band_objects(figure);
  script += marker_lines(placed_markers(figure, horizontal));
  return script + curve_data(figure, vertical) + plot_command(figure);
}

}  // namespace slosh::reports
