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

}  // namespace slosh::reports
