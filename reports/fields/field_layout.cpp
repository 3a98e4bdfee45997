#include "reports/fields/field_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/drawing/axes.hpp"
#include "reports/drawing/figure_layout.hpp"

namespace slosh::reports {
namespace {

constexpr int widest_canvas = 1200;      // [px]: a page's column has 1112
constexpr int narrowest_canvas = 1000;   // [px]: the key's parts stand side by side
constexpr int tallest_cell = 560;        // [px]: two rows of the tallest tanks fit one screen
constexpr int widest_frame = 340;        // [px], a cell of an animation: dozens of them are drawn
constexpr int smallest_gap = 28;         // [px], between two columns; half of it at the sides
constexpr double wall = 3;               // [px], between a tank and its cell's edge
constexpr double round_off = 1e-9;       // [px]
constexpr double label_character = 8.8;  // [px], of gnuplot's 'sans,12' on average (measured)

// The rectangle that holds all tanks as they are rolled [m from the axis].
struct PlotExtent {
  double left = std::numeric_limits<double>::infinity(), right = -left, bottom = left, top = -left;
};

PlotExtent rolled_tanks(const FieldFigure& figure) {
  PlotExtent extent;
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

}  // namespace

double scale_bar_length(const FieldLayout& layout, double longest) {
  return round_tick(longest / layout.scale, false);
}

std::string scale_bar_text(double length) {
  return length < 1 ? fmt::format("{:.6g} mm", 1000 * length) : fmt::format("{:.6g} m", length);
}

int most_columns() { return widest_canvas / (smallest_gap + 2 * static_cast<int>(wall) + 1); }

int FieldLayout::row_height() const { return label_lines * label_line + cell_height + row_gap; }

int FieldLayout::row_top(int row) const { return key_height + row * row_height(); }

Pixel FieldLayout::turned(const FieldPanel& panel, double along_x, double along_z) const {
  const double cosine = std::cos(panel.angle), sine = std::sin(panel.angle);
  return {scale * (cosine * along_x - sine * along_z), scale * (sine * along_x + cosine * along_z)};
}

Pixel FieldLayout::in_cell(const FieldPanel& panel, double x, double z) const {
  const Pixel from_axis = turned(panel, x - panel.axis_x, z - panel.axis_z);
  return {axis.x + from_axis.x, axis.y + from_axis.y};
}

bool FieldLayout::holds(const Pixel& place) const {
  return place.x >= 0 && place.x < cell_width && place.y >= 0 && place.y < cell_height;
}

namespace {

// The grid, and the cells as large as they may be.
FieldLayout grid_of_cells(const FieldFigure& figure, double highest_tank, double widest_tank) {
  FieldLayout layout{};
  const int panels = static_cast<int>(figure.panels.size());
  layout.columns = std::min(figure.columns, panels);
  layout.rows = (panels + layout.columns - 1) / layout.columns;
  const PlotExtent extent = rolled_tanks(figure);
  const double width = extent.right - extent.left, height = extent.top - extent.bottom;
  layout.scale = std::min(widest_tank / width, highest_tank / height);
  layout.cell_width = static_cast<int>(std::ceil(layout.scale * width + 2 * wall - round_off));
  layout.cell_height = static_cast<int>(std::ceil(layout.scale * height + 2 * wall - round_off));
  layout.axis = {wall - layout.scale * extent.left, wall - layout.scale * extent.bottom};
  return layout;
}

}  // namespace

FieldLayout field_layout(const FieldFigure& figure) {
  const int columns = std::min(figure.columns, static_cast<int>(figure.panels.size()));
  const int widest = widest_canvas / columns - smallest_gap;
  FieldLayout layout =
      grid_of_cells(figure, tallest_cell - 2 * wall,
                    (figure.is_animation ? std::min(widest, widest_frame) : widest) - 2 * wall);
  layout.width = std::clamp(layout.columns * (layout.cell_width + smallest_gap), narrowest_canvas,
                            widest_canvas);
  layout.column_gap = layout.width / layout.columns - layout.cell_width;
  layout.left = layout.column_gap / 2;
  for (const FieldPanel& panel : figure.panels) {
    layout.labels.push_back(wrapped(panel.label, layout.cell_width, label_character));
    layout.label_lines =
        std::max(layout.label_lines, static_cast<int>(layout.labels.back().size()));
  }
  layout.height = layout.row_top(layout.rows);
  return layout;
}

}  // namespace slosh::reports
