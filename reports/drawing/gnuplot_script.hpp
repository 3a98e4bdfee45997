// The gnuplot program that draws one figure, as SVG or PNG, on its standard output.
//
// All text goes in single quotes, where gnuplot expands nothing (no command, no macro, no escape);
// all data goes in inline datablocks. The program needs gnuplot 5.4 (keyentry, set minussign).
#pragma once

#include <string>

#include "reports/model/report_model.hpp"

namespace slosh::reports {

inline constexpr int canvas_width = 760;          // px, the width of a page's text column
inline constexpr std::size_t drawn_limit = 1500;  // entries a curve: two a pixel of the canvas

// Height of the canvas in px: the plot's own, and what its legend and its rows of marker labels
// need.
int canvas_height(const Figure& figure);

enum class Terminal { svg, png };  // the latter with twice the pixels

std::string gnuplot_script(const Figure& figure, Terminal terminal = Terminal::svg);

}  // namespace slosh::reports
