// The grid of panels in a picture of flow fields. gnuplot's multiplot places the panels; this
// computes the sizes that it is given and that the arrows and the raster depend on.
//
// All panels have one scale and cells of one size, which hold every tank as it is rolled. The
// tank's axis stands at the same place of each cell, so that a roll shows from panel to panel.
#pragma once

#include <string>
#include <vector>

#include "reports/model/report_model.hpp"

namespace slosh::reports {

struct Pixel {
  double x, y;  // [px] from the lower left corner of a panel's cell
};

struct FieldLayout {
  int width, height;            // [px] of the canvas
  int columns, rows;            // of panels
  int cell_width, cell_height;  // [px]
  int left, column_gap;         // [px], left of the first column and between two columns
  int label_lines;              // above each cell
  double scale;                 // [px/m]
  Pixel axis;                   // of every tank, in its cell
  std::vector<std::vector<std::string>> labels;  // the panels' labels, broken into lines

  int row_height() const;      // [px], a row of labels, its cells and the gap below
  int row_top(int row) const;  // [px] from the canvas' top

  // A vector in the tank's directions [m], as it shows on the canvas [px].
  Pixel turned(const FieldPanel& panel, double along_x, double along_z) const;
  // The place (x, z) of a tank [m] in its cell.
  Pixel in_cell(const FieldPanel& panel, double x, double z) const;
  bool holds(const Pixel& place) const;  // whether the place is inside a cell
};

inline constexpr int key_height = 96;  // [px], at the top: colour bar, arrow and scale bar
inline constexpr int label_line = 21;  // [px], of gnuplot's 'sans,12'
inline constexpr int row_gap = 16;     // [px], below a cell

// Returns the length of a scale bar that is at most this long [px], in m: a round one.
double scale_bar_length(const FieldLayout& layout, double longest);
std::string scale_bar_text(double length);

// The number of panels in a row for which the widest canvas leaves each tank a pixel.
int most_columns();

// The figure has at most that many panels in a row.
FieldLayout field_layout(const FieldFigure& figure);

}  // namespace slosh::reports
