#include "reports/fields/field_layout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "reports/drawing/gnuplot_text.hpp"

namespace slosh::reports {
namespace {

constexpr double widest_canvas = 1200;           // px: a page's column has 1112
constexpr double narrowest_canvas = 1000;        // px: the key's parts side by side
constexpr double tallest_cell = 560;             // px: two rows of the tallest tanks on one screen
constexpr double column_gap = 28, row_gap = 16;  // px
constexpr double wall = 3;  // px, around the tanks in a cell: their outline is drawn there

// What holds all tanks as they are turned, from the axis [m].
struct Extent {
  double left = std::numeric_limits<double>::infinity(), right = -left, bottom = left, top = -left;

  double width() const { return right - left; }
  double height() const { return top - bottom; }
};

Extent turned_tanks(const FieldFigure& figure) {
  Extent extent;
  for (const FieldPanel& panel : figure.panels) {
    const double cosine = std::cos(panel.angle), sine = std::sin(panel.angle);
    for (const double x : {-panel.axis_x, panel.tank_length - panel.axis_x}) {
      for (const double z : {-panel.axis_z, panel.tank_height - panel.axis_z}) {
        extent.left = std::min(extent.left, cosine * x - sine * z);
        extent.right = std::max(extent.right, cosine * x - sine * z);
        extent.bottom = std::min(extent.bottom, sine * x + cosine * z);
        extent.top = std::max(extent.top, sine * x + cosine * z);
      }
    }
  }
  return extent;
}

void append(std::vector<std::string>& lines, const std::string& words, double width) {
  std::string longer = lines.back();
  if (!longer.empty()) longer += ' ';
  longer += words;
  if (lines.back().empty() || text_width(longer, label_character) <= width)
    lines.back() = longer;
  else
    lines.push_back(words);
}

// Broken after commas, and between words only where what stands between two commas is too wide; a
// word that is wider than the cell stays whole.
std::vector<std::string> wrapped(const std::string& label, double width) {
  std::vector<std::string> lines(1);
  for (std::size_t start = 0; start < label.size();) {
    const std::size_t comma = std::min(label.find(", ", start), label.size() - 1);
    const std::string clause = label.substr(start, comma + 1 - start);
    start = std::min(label.find_first_not_of(' ', comma + 1), label.size());
    if (text_width(clause, label_character) <= width) {
      append(lines, clause, width);
      continue;
    }
    std::istringstream words(clause);
    for (std::string word; words >> word;) append(lines, word, width);
  }
  return lines;
}

}  // namespace

FieldLayout field_layout(const FieldFigure& figure) {
  const int panels = static_cast<int>(figure.panels.size());
  const int columns = std::min(figure.columns, panels), rows = (panels + columns - 1) / columns;
  const Extent extent = turned_tanks(figure);
  const double gaps = 2 * canvas_margin + (columns - 1) * column_gap;
  const double widest_cell = (widest_canvas - gaps) / columns;
  FieldLayout layout{};
  layout.scale =
      std::min((widest_cell - 2 * wall) / extent.width(),
               ((figure.panel_height > 0 ? figure.panel_height : tallest_cell) - 2 * wall) /
                   extent.height());
  const double cell_width = std::ceil(layout.scale * extent.width() + 2 * wall),
               cell_height = std::ceil(layout.scale * extent.height() + 2 * wall);
  layout.width =
      static_cast<int>(std::clamp(columns * cell_width + gaps, narrowest_canvas, widest_canvas));
  const double column_width = (layout.width - gaps) / columns;

  double from_top = key_height;
  for (int row = 0; row < rows; ++row) {
    const int first = row * columns, end = std::min(first + columns, panels);
    std::size_t lines = 0;
    for (int i = first; i < end; ++i) {
      const FieldPanel& panel = figure.panels[static_cast<std::size_t>(i)];
      const double left = std::floor(canvas_margin + (i - first) * (column_width + column_gap) +
                                     (column_width - cell_width) / 2);
      layout.panels.push_back(
          {.left = left,
           .bottom = 0,
           .width = cell_width,
           .height = cell_height,
           .label = wrapped(panel.label, cell_width),
           .scale = layout.scale,
           .tank_axis_x = panel.axis_x,
           .tank_axis_z = panel.axis_z,
           .axis = {left + wall - layout.scale * extent.left, wall - layout.scale * extent.bottom},
           .cosine = std::cos(panel.angle),
           .sine = std::sin(panel.angle)});
      lines = std::max(lines, layout.panels.back().label.size());
    }
    from_top += static_cast<double>(lines) * label_line + cell_height;
    // Counted from the top so far: the canvas' height is not known yet.
    for (int i = first; i < end; ++i) layout.panels[static_cast<std::size_t>(i)].bottom = -from_top;
    from_top += row_gap;
  }
  layout.height = static_cast<int>(from_top);
  for (PlacedPanel& panel : layout.panels) {
    panel.bottom += layout.height;
    panel.axis.y += panel.bottom;
  }
  return layout;
}

FilmFrames film_frames(const FieldFigure& figure, const FieldLayout& layout) {
  const auto columns = static_cast<std::size_t>(figure.columns);
  FilmFrames film{{}, 0};
  for (std::size_t row = 0; row < figure.frames.size(); ++row) {
    double top = layout.height, bottom = layout.height;  // from the canvas' top
    for (std::size_t i = row * columns; i < std::min((row + 1) * columns, layout.panels.size());
         ++i) {
      const PlacedPanel& panel = layout.panels[i];
      bottom = layout.height - panel.bottom;
      top = std::min(top,
                     bottom - panel.height - static_cast<double>(panel.label.size()) * label_line);
    }
    film.tops.push_back(top);
    film.height = std::max(film.height, bottom - top);
  }
  return film;
}

}  // namespace slosh::reports
