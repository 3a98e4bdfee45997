// The gnuplot program that draws one figure, as SVG or PNG, on its standard output.
//
// All text is in single quotes, where gnuplot expands nothing (no command, no macro, no escape).
// All data is in inline datablocks. The program needs gnuplot 5.4 (keyentry, set minussign).
#pragma once

#include <string>

#include "reports/model/report_model.hpp"

namespace slosh::reports {

enum class Terminal { svg, png };  // a PNG has twice the pixels

std::string gnuplot_script(const Figure& figure, Terminal terminal = Terminal::svg);

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

}  // namespace slosh::reports
