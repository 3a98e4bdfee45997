// The curves of a figure in gnuplot's language: their data, and the command that plots them.
#pragma once

#include <string>

#include "reports/drawing/axes.hpp"
#include "reports/model/report_model.hpp"

namespace slosh::reports {

inline constexpr std::size_t drawn_limit = 1100;  // entries of a curve: two per pixel of the canvas
inline constexpr std::size_t all_drawn_limit = 6 * drawn_limit;  // of all curves together

// How gnuplot draws a curve.
struct Stroke {
  const char* colour;  // on white paper
  int point;           // a gnuplot point type
  const char* dash;    // a gnuplot dash type
};

// `dashed` curves have dashes of their own, with longer gaps.
Stroke stroke_of(const Look& look, bool dashed = false);

// The colour of the figure's band of this index, on white paper.
const char* band_colour(const Figure& figure, std::size_t index);

// The inline datablocks of all curves and ribbons.
std::string curve_data(const Figure& figure, const AxisRange& vertical);

// Draws ribbons below all curves, and gives bands, spans and ribbons their legend entries.
std::string plot_command(const Figure& figure);

}  // namespace slosh::reports
