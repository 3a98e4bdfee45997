// The parts of a picture of flow fields: the range of its colours, the grid of its panels, their
// pixels, and the velocity arrows.
//
// All panels have one scale and cells of one size, which hold every tank as it is rolled. The
// tank's axis stands at the same place of each cell, so that a roll shows from panel to panel.
// gnuplot's multiplot places the panels; this computes the sizes that it is given.
//
// A pixel shows the nearest place whose rectangle is over it. gnuplot's own rectangles do worse.
// Its pngcairo terminal smooths every edge, so that neighbours show seams, and the mixed colours
// make a picture of 12 panels 1.4 times as large (431 kB without arrows against 308 kB with them,
// measured with boxes that overlap to hide the seams). Its png terminal (libgd) smooths nothing,
// neither the arrows nor the outlines. Neither fills the gaps between particles without moving the
// water's edge.
#pragma once

#include <string>
#include <vector>

#include "reports/model/report_model.hpp"

namespace slosh::reports {

// Whether a colour bar can tell the two ends apart.
bool is_range(double lower, double upper);

struct ColourRange {
  double lower, upper;                   // lower < upper
  double step;                           // between two ticks: 1, 2 or 5 times a power of ten
  std::string lower_label, upper_label;  // "≤" or "≥" marks an end beyond which values lie
};

// Returns the value as a bar names it.
std::string bar_label(double value);

// The ticks between the two ends of a colour bar are first, first + step, and so on up to last.
struct BarTicks {
  double first, last;
};

// Returns the ticks whose labels stay clear of those of the ends, which are drawn too, on a bar of
// this length [px].
BarTicks bar_ticks(const ColourRange& range, double bar_length);

// Returns the given value_range, or what holds the 1st to the 99th percentile of all panels'
// values, rounded outwards to a tick: one particle in a jet does not bleach all others.
ColourRange colour_range(const FieldFigure& figure);

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

inline constexpr int colour_levels = 64;  // a smooth bar; 128 make the file a tenth larger
inline constexpr int no_level = -1;

// Returns the levels of the cell's pixels, row by row from the bottom up to the highest place: 0 to
// colour_levels - 1, or no_level where no place is. Values beyond the range take its end's colour.
// A place that is not finite or outside the cell is not drawn; any other has one pixel at least.
// Gaps between particles, of a fraction of their spacing, are filled from the nearest place; the
// water's edge stays where it is.
std::vector<int> field_raster(const FieldPanel& panel, const FieldLayout& layout,
                              const ColourRange& range);

struct DrawnArrow {
  Pixel tail, length;  // [px] in the panel's cell
};

struct FieldArrows {
  double pixels_per_speed = 0;  // [px per m/s]; 0 where nothing moves
  double legend_speed = 0;      // [m/s], a round one
  double cut_speed = 0;         // [m/s], faster arrows are cut to this one's length; 0: none was
  std::vector<std::vector<DrawnArrow>> panels;  // in the figure's order
};

// What the legend says of the arrow of legend_speed; empty where nothing moves.
std::string arrow_text(const FieldArrows& arrows);

inline constexpr std::size_t most_arrows = 300;  // in a panel

// Keeps one arrow in each square of a cell, the nearest to its centre. The squares have one size
// in all panels, as small as arrows can be told apart and as most_arrows allows. With an automatic
// scale the 95th percentile of all speeds is a little shorter than two squares. An arrow that would
// end outside its cell, on a neighbour or on a label, is left out.
FieldArrows field_arrows(const FieldFigure& figure, const FieldLayout& layout);

}  // namespace slosh::reports
