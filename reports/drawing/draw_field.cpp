#include "reports/drawing/draw_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "reports/drawing/field_parts.hpp"
#include "reports/drawing/figure_palette.hpp"
#include "reports/drawing/gnuplot_script.hpp"
#include "reports/model/report_files.hpp"
#include "reports/model/report_model.hpp"

namespace slosh::reports {
namespace {

constexpr double half_width = 0.75;  // [px], of the line
// A corner moves by less than this many half widths, however sharp it is.
constexpr double farthest = 4;

std::vector<TankCorner> corners_of(const FieldPanel& panel) {
  if (!panel.outline.empty()) return panel.outline;
  const double length = panel.tank_length, height = panel.tank_height;
  return {{0, 0}, {length, 0}, {length, height}, {0, height}};
}

// The unit normal that points out of the water, of a side of corners that count counter-clockwise.
TankCorner outward(const TankCorner& from, const TankCorner& to) {
  const double x = to.x - from.x, z = to.z - from.z, length = std::hypot(x, z);
  if (!(length > 0)) return {0, 0};
  return {z / length, -x / length};
}

// The key stands above the panels: the scale bar, the arrow's legend and the colour bar.
constexpr double bar_start = 0.44, bar_width = 0.5;        // of the canvas' width
constexpr double scale_start = 0.018, arrow_start = 0.19;  // of the canvas' width
constexpr double bar_height = 16;                          // [px]
constexpr double bar_bottom = 38, words_middle = 57;       // [px] from the canvas' top
constexpr double longest_scale_bar = 150;                  // [px]

// The second axes of each panel are its cell's pixels; the first are those of the image, whose
// middles of pixels are whole numbers. A velocity arrow is drawn white (style 1) below dark (style
// 2), so that it shows on every colour. Style 3 is the scale bar.
std::string canvas(const FieldLayout& layout) {
  const auto across = [&](int pixels) { return static_cast<double>(pixels) / layout.width; };
  const auto down = [&](int pixels) { return static_cast<double>(pixels) / layout.height; };
  const int right =
      layout.left + layout.columns * (layout.cell_width + layout.column_gap) - layout.column_gap;
  const int label_height = layout.label_lines * label_line;
  return fmt::format(
      "unset border\nunset tics\nunset key\nset x2range [0:{}]\nset y2range [0:{}]\n"
      "set xrange [-0.5:{}]\nset yrange [-0.5:{}]\n"
      "set style arrow 1 head size screen {:.6f},22 nofilled lw 2.2 lc rgb '{}'\n"
      "set style arrow 2 head size screen {:.6f},22 nofilled lw 1.2 lc rgb '{}'\n"
      "set style arrow 3 heads size screen {:.6f},90 lw 1.6 lc rgb '{}'\n"
      "set multiplot layout {},{} margins screen {:.7f},{:.7f},{:.7f},{:.7f} "
      "spacing screen {:.7f},{:.7f}\n",
      layout.cell_width, layout.cell_height, layout.cell_width - 0.5, layout.cell_height - 0.5,
      across(6), paper.light, across(6), ink.light, across(5), ink.light, layout.rows,
      layout.columns, across(layout.left), across(right), down(row_gap),
      1 - down(key_height + label_height), across(layout.column_gap), down(row_gap + label_height));
}

// The scale of the colours is that of the image, whose values are levels: gnuplot would take a
// second for each panel to compute the values of all pixels.
std::string colour_bar(const FieldFigure& figure, const FieldLayout& layout,
                       const ColourRange& range) {
  std::vector<std::string> colours, marks;
  for (std::size_t i = 0; i < field_colours.size(); ++i)
    colours.push_back(fmt::format("{} '{}'", i, field_colours[i]));
  const auto mark = [&](const std::string& label, double value) {
    const double share = (value - range.lower) / (range.upper - range.lower);
    marks.push_back(fmt::format("{} {:.4f}", quoted(label), colour_levels * share - 0.5));
  };
  const BarTicks ticks = bar_ticks(range, bar_width * layout.width);
  mark(range.lower_label, range.lower);
  for (double tick = ticks.first; tick <= ticks.last + range.step / 4; tick += range.step)
    mark(bar_label(tick), tick);
  mark(range.upper_label, range.upper);
  return fmt::format(
      "set palette maxcolors {} defined ({})\nset cbrange [-0.5:{}]\n"
      "set colorbox user horizontal origin screen {},{:.5f} size screen {},{:.5f} noborder\n"
      "set cbtics ({}) out nomirror scale 0.6 offset 0,0.4 textcolor rgb '{}'\n"
      "set cblabel {} offset 0,0.8 textcolor rgb '{}'\n",
      colour_levels, fmt::join(colours, ", "), colour_levels - 0.5, bar_start,
      1 - bar_bottom / layout.height, bar_width, bar_height / layout.height, fmt::join(marks, ", "),
      ink.light, quoted(figure.value_label), ink.light);
}

// A part of the key: an arrow of the given length [px] with words below it.
std::string key_part(const FieldLayout& layout, double start, double length, int style,
                     const std::string& words) {
  return fmt::format(
      "set arrow from screen {0},{1:.5f} to screen {2:.5f},{1:.5f} arrowstyle {3}\n"
      "set label {4} at screen {0},{5:.5f} left textcolor rgb '{6}'\n",
      start, 1 - (bar_bottom - bar_height / 2) / layout.height, start + length / layout.width,
      style, quoted(words), 1 - words_middle / layout.height, ink.light);
}

std::string scale_bar(const FieldLayout& layout) {
  const double length = scale_bar_length(layout, longest_scale_bar);
  return key_part(layout, scale_start, length * layout.scale, 3, scale_bar_text(length));
}

std::string arrow_legend(const FieldLayout& layout, const FieldArrows& arrows) {
  const std::string words = arrow_text(arrows);
  if (words.empty()) return "";
  return key_part(layout, arrow_start, arrows.legend_speed * arrows.pixels_per_speed, 2, words);
}

std::string data_blocks(const FieldPanel& panel, const FieldLayout& layout,
                        const std::vector<int>& levels, const std::vector<DrawnArrow>& arrows) {
  std::string blocks = "$field << END\n";
  for (std::size_t i = 0; i < levels.size(); ++i) {
    blocks += levels[i] == no_level ? "NaN" : std::to_string(levels[i]);
    blocks += (i + 1) % static_cast<std::size_t>(layout.cell_width) == 0 ? '\n' : ' ';
  }
  blocks += "END\n$tank << END\n";
  std::vector<Pixel> line = tank_line(panel, layout);
  line.push_back(line.front());
  for (const Pixel& corner : line) blocks += fmt::format("{:.2f} {:.2f}\n", corner.x, corner.y);
  blocks += "END\n$arrows << END\n";
  for (const auto& [tail, length] : arrows)
    blocks += fmt::format("{:.1f} {:.1f} {:.1f} {:.1f}\n", tail.x, tail.y, length.x, length.y);
  return blocks + "END\n";
}

std::string plot_command(bool has_arrows) {
  std::string command = fmt::format(
      "plot $field matrix with image, \\\n  $tank axes x2y2 with lines lw 1.5 lc rgb '{}'",
      faint_ink.light);
  for (const int style : {1, 2})
    if (has_arrows)
      command += fmt::format(", \\\n  $arrows axes x2y2 with vectors arrowstyle {}", style);
  return command + "\n";
}

// What the panels of a figure share.
struct FieldDrawing {
  const FieldFigure& figure;
  FieldLayout layout;  // of the whole picture, or of each frame of an animation
  ColourRange range;
  FieldArrows arrows;
};

FieldDrawing drawing_of(const FieldFigure& figure) {
  FieldDrawing drawing{figure, field_layout(figure), colour_range(figure), {}};
  drawing.arrows = field_arrows(figure, drawing.layout);
  if (!figure.is_animation) return drawing;
  drawing.layout.rows = 1;
  drawing.layout.height = drawing.layout.row_top(1);
  return drawing;
}

std::string terminal(const FieldDrawing& drawing) {
  constexpr int frame_delay = 15;  // hundredths of a second
  return fmt::format(
      "set encoding utf8\nset minussign\n"
      "set terminal {} size {},{} font 'sans,12' noenhanced background rgb '{}'\n",
      drawing.figure.is_animation ? fmt::format("gif animate delay {} loop 0 optimize", frame_delay)
                                  : "pngcairo",
      drawing.layout.width, drawing.layout.height, paper.light);
}

// One multiplot, which places these panels. All data is in inline datablocks.
std::string multiplot(const FieldDrawing& drawing, std::size_t first, std::size_t count) {
  const auto& [figure, layout, range, arrows] = drawing;
  std::string script = canvas(layout) + colour_bar(figure, layout, range) + scale_bar(layout) +
                       arrow_legend(layout, arrows);
  for (std::size_t i = first; i < first + count; ++i) {
    std::vector<std::string> lines;
    for (const std::string& line : layout.labels[i]) lines.push_back(quoted(line));
    script += fmt::format("set title {} offset 0,-0.7 textcolor rgb '{}'\n",
                          fmt::join(lines, ".\"\\n\"."), ink.light);
    script += data_blocks(figure.panels[i], layout, field_raster(figure.panels[i], layout, range),
                          arrows.panels[i]);
    script += plot_command(!arrows.panels[i].empty());
    if (i == first)
      script += "unset arrow\nunset label\nunset colorbox\n";  // the key is drawn once
  }
  return script + "unset multiplot\n";
}

// An animation has a frame for each row.
std::string field_script(const FieldDrawing& drawing) {
  const std::size_t panels = drawing.figure.panels.size(),
                    in_frame = drawing.figure.is_animation
                                   ? static_cast<std::size_t>(drawing.layout.columns)
                                   : panels;
  std::string script = terminal(drawing);
  for (std::size_t first = 0; first < panels; first += in_frame)
    script += multiplot(drawing, first, in_frame);
  return script;
}

}  // namespace

// Both sides at a corner move out by the same distance: the corner moves by (n1 + n2) / (1 + n1 n2)
// of it, whose length is the root of 2 / (1 + n1 n2).
std::vector<Pixel> tank_line(const FieldPanel& panel, const FieldLayout& layout) {
  const std::vector<TankCorner> corners = corners_of(panel);
  const double out = half_width / layout.scale;
  std::vector<Pixel> line;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const TankCorner &before = corners[(i + corners.size() - 1) % corners.size()], &at = corners[i],
                     &after = corners[(i + 1) % corners.size()];
    const TankCorner one = outward(before, at), other = outward(at, after);
    const double share =
        out / std::max(1 + one.x * other.x + one.z * other.z, 2 / (farthest * farthest));
    line.push_back(
        layout.in_cell(panel, at.x + share * (one.x + other.x), at.z + share * (one.z + other.z)));
  }
  return line;
}

DrawnField draw_field(const FieldFigure& figure, const std::filesystem::path& scratch_directory,
                      const Gnuplot& gnuplot) {
  const FieldDrawing drawing = drawing_of(figure);
  std::string picture = gnuplot(field_script(drawing), figure.id, scratch_directory);
  if (figure.is_animation ? !is_whole_gif(picture) : !is_whole_png(picture))
    throw ReportError(
        broken_output(figure.id, figure.is_animation ? "GIF file" : "PNG file", scratch_directory));
  return {std::move(picture), drawing.layout.width, drawing.layout.height};
}

std::string description(const FieldFigure& figure) {
  const auto shown =
      figure.is_animation ? static_cast<std::size_t>(figure.columns) : figure.panels.size();
  std::vector<std::string> labels;
  for (std::size_t i = 0; i < shown; ++i) labels.push_back(figure.panels[i].label);
  const ColourRange range = colour_range(figure);
  const bool has_arrows = std::any_of(figure.panels.begin(), figure.panels.end(),
                                      [](const auto& panel) { return !panel.arrow_x.empty(); });
  return fmt::format("{}. {}: {}. Colour: {} from {} to {}.{}", figure.title,
                     figure.is_animation ? "Panels of the first moment" : "Panels",
                     fmt::join(labels, "; "), figure.value_label, range.lower_label,
                     range.upper_label, has_arrows ? " Arrows: velocity." : "");
}

std::string picture_file(const FieldFigure& figure) {
  return figure.id + (figure.is_animation ? ".gif" : ".png");
}

std::string data_address(const FieldFigure& figure, const DrawnField& drawn) {
  return fmt::format("data:image/{};base64,{}", figure.is_animation ? "gif" : "png",
                     base64(drawn.picture));
}

}  // namespace slosh::reports
