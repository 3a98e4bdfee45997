// The canvas of a figure: its axes and their ticks, its size, the places of its legend and of its
// markers' labels, and the samples of a long curve that are drawn.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "reports/model/report_model.hpp"

namespace slosh::reports {

struct AxisRange {
  double lower, upper;  // lower < upper, both finite; both positive on a logarithmic axis
};

// The nearest 1, 2 or 5 times a power of ten at or beyond the value, which is above zero.
double round_tick(double value, bool up);

struct PlotRanges {
  AxisRange horizontal, vertical;
};

// Returns the given ranges, or those of what is drawn. Where the figure's axes are equal, the
// narrower range is widened about its middle.
PlotRanges plot_ranges(const Figure& figure);

// Returns gnuplot's tick list for a logarithmic axis. The ticks are at 1, 2 and 5 times the powers
// of ten over up to three decades, and at powers of ten over more.
std::string logarithmic_ticks(const AxisRange& range);

// Whether gnuplot can place the sample: it is finite (a diverged 1e300 does not count as finite),
// and positive on logarithmic axes.
bool drawable(const Figure& figure, double x, double y);

// Returns the indices of the samples to draw, in order, at most `limit` (>= 5) of them;
// std::nullopt is a gap. A longer curve is cut into equal runs of samples. The lowest sample, the
// highest and one gap of each run are kept, and the curve's two ends.
std::vector<std::optional<std::size_t>> drawn_samples(const Figure& figure, const Curve& curve,
                                                      std::size_t limit);

// Texts as gnuplot draws them: how wide they are, and where they break into lines.

// The approximate width [px] of a text as drawn, to lay labels out; each UTF-8 character counts
// once.
double text_width(const std::string& text, double character_width);

// Breaks a text into lines of at most this width [px], as gnuplot does not. A line ends at the last
// comma within the width or, where there is none, at the last blank within it. A word that is wider
// has a line of its own.
std::vector<std::string> wrapped(std::string text, double width, double character_width);

inline constexpr int legend_row_height = 20;  // px, also of a row of marker labels

// The size of the canvas and of its text. A small figure has no legend.
struct Canvas {
  int width;          // px
  int plot_height;    // px, axis labels included, legend not
  int below_frame;    // px: ticks, numbers, the axis label and a gap before the legend
  int font_size;      // px
  double line_width;  // of a curve, before gnuplot's scale
};

Canvas canvas_of(const Figure& figure);

// The texts of the legend that are not a curve's, each once.
std::vector<std::string> span_labels(const Figure& figure);
std::vector<std::string> ribbon_labels(const Figure& figure);

// The lines of one entry of the legend. A legend with an entry of several has one column.
std::vector<std::string> legend_lines(const std::string& label);

struct KeyLayout {
  int columns, rows;
  double narrower;  // characters to take off each entry: gnuplot assumes wide ones, 0.7 of the font
                    // size
};

KeyLayout key_layout(const Figure& figure);

struct PlacedMarker {
  const Marker* marker;
  int row;  // of its label, counted upwards from the frame
};

// Puts each label in the lowest row above the frame in which it does not touch its left neighbour.
std::vector<PlacedMarker> placed_markers(const Figure& figure, const AxisRange& range);

int marker_rows(const std::vector<PlacedMarker>& placed);

// The height of the legend at the canvas' foot [px].
int legend_height(const Figure& figure);

// The height of the canvas [px]: the plot's own, and that of its legend and of its rows of marker
// labels.
int canvas_height(const Figure& figure);

}  // namespace slosh::reports
