// Turns what gnuplot's SVG terminal writes into markup that many figures of one page can share.
#pragma once

#include <string>

namespace slosh::reports {

// The drawing inside gnuplot's <svg> element, with every id and every reference to one starting
// with "plot-<figure_id>-", the palette's colours as #rrggbb (so that dark_rules() find them), the
// page's font and no empty groups. Text between tags is left as it is. Throws ReportError where
// there is no drawing.
std::string shared_markup(const std::string& gnuplot_svg, const std::string& figure_id);

}  // namespace slosh::reports
