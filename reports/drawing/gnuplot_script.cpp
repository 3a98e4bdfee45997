#include "reports/drawing/gnuplot_script.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <system_error>
#include <vector>

#include "reports/drawing/figure_layout.hpp"
#include "reports/drawing/figure_palette.hpp"
#include "reports/model/report_files.hpp"
#include "reports/model/report_model.hpp"
#include "verification/files/child_process.hpp"
#include "verification/files/foreign/legible_text.hpp"

namespace slosh::reports {
namespace {

constexpr std::size_t drawn_limit = 1100;  // entries of a curve: two per pixel of the canvas
constexpr std::size_t all_drawn_limit = 6 * drawn_limit;  // of all curves together
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

// Writes a datablock of the drawn samples: the line of each, and one blank line per gap, which an
// empty line is too. Two consecutive blank lines would end the data set.
template <class Line>
std::string datablock(const std::string& name, const Figure& figure, const Curve& curve,
                      const Line& line_of) {
  std::string block = fmt::format("${} << END\n", name);
  bool in_gap = true;
  for (const auto& index : drawn_samples(figure, curve, entries_of_a_curve(figure))) {
    const std::string line = index ? line_of(*index) : "";
    if (!line.empty() || !in_gap) block += line + '\n';
    in_gap = line.empty();
  }
  return block + "END\n";
}

std::string curve_block(const Figure& figure, std::size_t number) {
  const Curve& curve = figure.curves[number];
  return datablock(fmt::format("curve_{}", number), figure, curve, [&](std::size_t i) {
    std::string line = fmt::format("{:.9g} {:.9g}", curve.x[i], curve.y[i]);
    for (const auto* bars : {&curve.x_error, &curve.y_error})
      if (!bars->empty()) line += fmt::format(" {:.9g}", (*bars)[i]);
    return line;
  });
}

// Writes the samples of which both edges are finite. On a logarithmic axis an edge that is not
// positive lies on the frame.
std::string ribbon_block(const Figure& figure, std::size_t number, const AxisRange& vertical) {
  const Curve& curve = figure.curves[number];
  return datablock(fmt::format("ribbon_{}", number), figure, curve,
                   [&](std::size_t i) -> std::string {
                     if (!std::isfinite(curve.lower[i]) || !std::isfinite(curve.upper[i]))
                       return "";
                     const double lower =
                         figure.log_y ? std::max(curve.lower[i], vertical.lower) : curve.lower[i];
                     return fmt::format("{:.9g} {:.9g} {:.9g}", curve.x[i], lower,
                                        std::max(lower, curve.upper[i]));
                   });
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

// A shaded rectangle behind the curves between two corners in gnuplot's words.
std::string shaded(const std::string& from, const std::string& to, const char* colour) {
  return fmt::format(
      "set object rectangle from {} to {} behind fc rgb '{}' fs transparent solid {} noborder\n",
      from, to, colour, band_opacity);
}

std::string band_objects(const Figure& figure) {
  std::string commands;
  for (std::size_t i = 0; i < figure.bands.size(); ++i) {
    const Band& band = figure.bands[i];
    if (std::isnan(band.lower) || std::isnan(band.upper)) continue;
    const auto level = [&](double value, int edge) {
      return std::isfinite(value) && !(figure.log_y && value <= 0)
                 ? fmt::format("graph {}, first {:.9g}", edge, value)
                 : fmt::format("graph {0}, graph {0}", edge);
    };
    commands += shaded(level(band.lower, 0), level(band.upper, 1), band_colour(figure, i));
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
    commands += shaded(fmt::format("first {:.9g}, graph 0", begin),
                       fmt::format("first {:.9g}, graph 1", end), faint_ink.light);
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

// The inline datablocks of all curves and ribbons.
std::string curve_data(const Figure& figure, const AxisRange& vertical) {
  std::string blocks;
  for (std::size_t i = 0; i < figure.curves.size(); ++i) {
    blocks += curve_block(figure, i);
    if (!figure.curves[i].lower.empty()) blocks += ribbon_block(figure, i, vertical);
  }
  return blocks;
}

// Draws ribbons below all curves, and gives bands, spans and ribbons their legend entries.
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

std::string gnuplot_script(const Figure& figure, Terminal terminal) {
  const auto [horizontal, vertical] = plot_ranges(figure);
  std::string script = canvas_commands(figure, terminal);
  script += axis('x', figure.x_label, horizontal, figure.log_x) + named_ticks(figure);
  script += axis('y', figure.y_label, vertical, figure.log_y);
  script += span_objects(figure, horizontal) + band_objects(figure);
  script += marker_lines(placed_markers(figure, horizontal));
  return script + curve_data(figure, vertical) + plot_command(figure);
}

std::filesystem::path gnuplot_program() { return program_on_path("gnuplot"); }

std::string run_gnuplot(const std::string& script, const std::string& figure_id,
                        const std::filesystem::path& scratch_directory) {
  return run_gnuplot_within(120, script, figure_id, scratch_directory);
}

std::string run_gnuplot_within(double time_limit, const std::string& script,
                               const std::string& figure_id,
                               const std::filesystem::path& scratch_directory) {
  const std::filesystem::path gnuplot = gnuplot_program();
  if (gnuplot.empty()) {
    throw ReportError(
        "gnuplot, which draws the report's figures, is not on the PATH (Debian: apt-get install "
        "gnuplot-nox)");
  }
  const auto program = scratch_directory / (figure_id + ".gp");
  const auto output = scratch_directory / (figure_id + ".out");
  write_text(program, script);
  try {
    ChildProcess child({gnuplot.string(), "--default-settings", program.string()},
                       {.log_file = output, .splits_errors = true});
    if (!child.ends_within(std::chrono::duration<double>(time_limit)))
      throw ReportError(
          fmt::format("figure '{}': gnuplot was ended at its time limit of {:g} s: {}", figure_id,
                      time_limit, child.errors()));
    if (child.wait_status() != 0)
      throw ReportError(fmt::format("figure '{}': gnuplot ended with status {}: {}", figure_id,
                                    child.exit_status(), child.errors()));
    return read_text(output);
  } catch (const std::system_error& failure) {
    throw ReportError(
        fmt::format("figure '{}': gnuplot did not start: {}", figure_id, failure.what()));
  }
}

std::string broken_output(const std::string& figure_id, const std::string& what,
                          const std::filesystem::path& scratch_directory) {
  constexpr std::uintmax_t a_page = 4096;  // [byte]: with less, the disk is as good as full
  std::error_code unknown;
  const auto space = std::filesystem::space(scratch_directory, unknown);
  const bool is_full = !unknown && space.available < a_page;
  return fmt::format("figure '{}': gnuplot's output is not a complete {}{}", figure_id, what,
                     is_full ? ": no space left in " + scratch_directory.string() : "");
}

std::string quoted(const std::string& text) {
  // gnuplot 5.4 takes the apostrophe at the start of a literal '''a' for the literal's end.
  const std::string shown = legible(text);
  const std::size_t apostrophes = std::min(shown.find_first_not_of('\''), shown.size());
  std::string literal = apostrophes == 0 ? "'" : "\"" + shown.substr(0, apostrophes) + "\".'";
  for (const char c : shown.substr(apostrophes)) {
    if (c == '\'') literal += '\'';
    literal += c == '\n' || c == '\t' ? ' ' : c;
  }
  return literal + "'";
}

}  // namespace slosh::reports
