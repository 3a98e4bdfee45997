#include "reports/fields/field_script.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "reports/drawing/axes.hpp"
#include "reports/drawing/figure_palette.hpp"
#include "reports/drawing/gnuplot_text.hpp"
#include "reports/fields/field_arrows.hpp"
#include "reports/fields/field_raster.hpp"

namespace slosh::reports {
namespace {

constexpr double bar_height = 16;         // px, of the colour bar
constexpr double bar_drop = 34;           // px, from the canvas' top to the bar's
constexpr double key_margin = 64;         // px, beside the colour bar: half the label of its end
constexpr double bar_start = 0.44;        // of the canvas' width: before it the arrow and the scale
constexpr double scale_bar_length = 150;  // px, at most
constexpr double arrow_start = 0.19;      // of the canvas' width

std::string canvas(const FieldLayout& layout) {
  return fmt::format(
      "set encoding utf8\n"
      "set terminal pngcairo size {0},{1} font 'sans,12' noenhanced background rgb '{2}'\n"
      "set lmargin at screen 0\nset rmargin at screen 1\n"
      "set bmargin at screen 0\nset tmargin at screen 1\n"
      "unset border\nunset tics\nunset key\nset xrange [0:{0}]\nset yrange [0:{1}]\n",
      layout.width, layout.height, paper.light);
}

std::string text(const std::string& words, double x, double y, const char* aligned) {
  return fmt::format("set label {} at {:.1f},{:.1f} {} textcolor rgb '{}'\n", quoted(words), x, y,
                     aligned, ink.light);
}

std::string colour_bar(const FieldFigure& figure, const FieldLayout& layout) {
  const ColourRange range = colour_range(figure);
  const double left = bar_start * layout.width, right = layout.width - key_margin;
  const double bottom = layout.height - bar_drop - bar_height;
  std::vector<std::string> colours;
  for (std::size_t i = 0; i < field_colours.size(); ++i)
    colours.push_back(fmt::format("{} '{}'", i, field_colours[i]));
  std::string commands = fmt::format(
      "set palette maxcolors {} defined ({})\nset cbrange [0:{}]\nunset cbtics\n"
      "set colorbox user horizontal origin screen {:.5f},{:.5f} size screen {:.5f},{:.5f} "
      "noborder\n",
      colour_levels, fmt::join(colours, ", "), colour_levels, left / layout.width,
      bottom / layout.height, (right - left) / layout.width, bar_height / layout.height);
  for (const auto& [value, label] : range.ticks) {
    const double fraction = (value / 2 - range.lower / 2) / (range.upper / 2 - range.lower / 2);
    const double x = left + fraction * (right - left);
    commands += fmt::format(
        "set arrow from {0:.1f},{1:.1f} to {0:.1f},{2:.1f} nohead lw 1.2 lc rgb '{3}'\n", x,
        bottom - 5, bottom, ink.light);
    commands += text(label, x, bottom - 17, "center");
  }
  return commands + text(figure.value_label, (left + right) / 2, layout.height - 17.0, "center");
}

// How long a metre of the tank is: on the bar's level, as is the arrow's legend.
std::string scale_bar(const FieldLayout& layout) {
  const double length = round_tick(scale_bar_length / layout.scale, false);  // [m]
  const double left = canvas_margin + 2, right = left + length * layout.scale;
  const double y = layout.height - bar_drop - bar_height / 2;
  std::string commands;
  for (const auto& [x1, y1, x2, y2] :
       {std::array{left, y, right, y}, std::array{left, y - 5, left, y + 5},
        std::array{right, y - 5, right, y + 5}}) {
    commands +=
        fmt::format("set arrow from {:.1f},{:.1f} to {:.1f},{:.1f} nohead lw 1.6 lc rgb '{}'\n", x1,
                    y1, x2, y2, ink.light);
  }
  return commands + text(length < 1 ? fmt::format("{:.6g} mm", 1000 * length)
                                    : fmt::format("{:.6g} m", length),
                         left, y - 25, "left");
}

// White below dark, so that an arrow shows on every colour.
std::string arrow_styles() {
  const std::string heads = "head size first 6,22 nofilled";
  return fmt::format(
      "set style arrow 1 {0} lw 2.2 lc rgb '{1}'\nset style arrow 2 {0} lw 1.2 lc rgb '{2}'\n",
      heads, paper.light, ink.light);
}

std::string arrow_legend(const FieldLayout& layout, const FieldArrows& arrows) {
  if (!(arrows.pixels_per_speed > 0)) return "";
  const double left = arrow_start * layout.width;
  const double y = layout.height - bar_drop - bar_height / 2;
  std::string words = fmt::format("{:.6g} m/s", arrows.legend_speed);
  if (arrows.cut_speed > 0) words += fmt::format(" (cut at {:.2g} m/s)", arrows.cut_speed);
  return fmt::format("set arrow from {:.1f},{:.1f} rto {:.1f},0 arrowstyle 2\n", left, y,
                     arrows.legend_speed * arrows.pixels_per_speed) +
         text(words, left, y - 25, "left");
}

std::string label(const PlacedPanel& panel) {
  std::string commands;
  for (std::size_t i = 0; i < panel.label.size(); ++i) {
    const double lines_below = static_cast<double>(panel.label.size() - i) - 0.5;
    commands += text(panel.label[i], panel.left,
                     panel.bottom + panel.height + lines_below * label_line, "left");
  }
  return commands;
}

std::string raster_block(std::size_t number, const FieldRaster& raster) {
  std::string block = fmt::format("$field_{} << END_OF_FIELD\n", number);
  for (std::size_t i = 0; i < raster.levels.size(); ++i) {
    block += raster.levels[i] == no_level ? "NaN" : std::to_string(raster.levels[i]);
    block += (i + 1) % static_cast<std::size_t>(raster.width) == 0 ? '\n' : ' ';
  }
  return block + "END_OF_FIELD\n";
}

std::string outline_block(std::size_t number, const FieldPanel& panel, const PlacedPanel& placed) {
  std::string block = fmt::format("$tank_{} << END_OF_TANK\n", number);
  // Half the line's width outside the water.
  const double out = 0.75 / placed.scale, right = panel.tank_length + out,
               top = panel.tank_height + out;
  for (const auto& [x, z] :
       {std::array{-out, -out}, std::array{right, -out}, std::array{right, top},
        std::array{-out, top}, std::array{-out, -out}}) {
    const Pixel corner = placed.on_canvas(x, z);
    block += fmt::format("{:.2f} {:.2f}\n", corner.x, corner.y);
  }
  return block + "END_OF_TANK\n";
}

std::string arrow_block(std::size_t number, const std::vector<DrawnArrow>& arrows) {
  std::string block = fmt::format("$arrows_{} << END_OF_ARROWS\n", number);
  for (const DrawnArrow& arrow : arrows) {
    block += fmt::format("{:.1f} {:.1f} {:.1f} {:.1f}\n", arrow.tail.x, arrow.tail.y,
                         arrow.length.x, arrow.length.y);
  }
  return block + "END_OF_ARROWS\n";
}

}  // namespace

std::string field_script(const FieldFigure& figure, const FieldLayout& layout) {
  const ColourRange range = colour_range(figure);
  const FieldArrows arrows = field_arrows(figure, layout);
  std::string script = canvas(layout) + colour_bar(figure, layout) + scale_bar(layout) +
                       arrow_styles() + arrow_legend(layout, arrows);
  std::vector<std::string> elements;
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const PlacedPanel& placed = layout.panels[i];
    const FieldRaster raster = field_raster(figure.panels[i], placed, range);
    script += label(placed) + outline_block(i, figure.panels[i], placed);
    if (!raster.levels.empty()) {
      script += raster_block(i, raster);
      // The middles of the pixels, and of the levels.
      elements.push_back(
          fmt::format("$field_{} matrix using ({}.5+$1):({}.5+$2):(0.5+$3) with image", i,
                      raster.left, raster.bottom));
    }
    elements.push_back(fmt::format("$tank_{} with lines lw 1.5 lc rgb '{}'", i, faint_ink.light));
    if (arrows.panels[i].empty()) continue;
    script += arrow_block(i, arrows.panels[i]);
    for (const int style : {1, 2})
      elements.push_back(fmt::format("$arrows_{} with vectors arrowstyle {}", i, style));
  }
  return script + fmt::format("plot {}\n", fmt::join(elements, ", \\\n  "));
}

}  // namespace slosh::reports
