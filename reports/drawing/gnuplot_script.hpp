// The gnuplot program that draws one figure, as SVG or PNG, on its standard output.
//
// All text is in single quotes, where gnuplot expands nothing (no command, no macro, no escape).
// All data is in inline datablocks. The program needs gnuplot 5.4 (keyentry, set minussign).
#pragma once

#include <string>

#include "reports/model/report_model.hpp"

namespace slosh::reports {

inline constexpr int canvas_width = 760;          // px, the width of a page's text column
inline constexpr std::size_t drawn_limit = 1500;  // entries per curve: two per pixel of the canvas

// The height of the canvas [px]: the plot's own, and that of its legend and of its rows of marker
// labels.
int canvas_height(const Figure& figure);

enum class Terminal { svg, png };  // a PNG has twice the pixels

std::string gnuplot_script(const Figure& figure, Terminal terminal = Terminal::svg);

}  // namespace slosh::reports
