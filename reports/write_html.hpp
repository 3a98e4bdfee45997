// The report as one self-contained HTML page.
#pragma once

#include <string>
#include <vector>

#include "reports/draw_figure.hpp"
#include "reports/report_model.hpp"

namespace slosh::reports {

// `drawings`: one for each figure, in the report's order.
std::string html_page(const Report& report, const std::vector<DrawnFigure>& drawings);

}  // namespace slosh::reports
