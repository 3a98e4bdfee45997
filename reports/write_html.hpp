// The report as one self-contained HTML page.
#pragma once

#include <string>
#include <vector>

#include "reports/draw_field.hpp"
#include "reports/draw_figure.hpp"
#include "reports/report_model.hpp"

namespace slosh::reports {

// What was drawn of a report: one for each figure and for each field, in the report's order.
struct Drawings {
  std::vector<DrawnFigure> figures;
  std::vector<DrawnField> fields;
};

std::string html_page(const Report& report, const Drawings& drawings);

}  // namespace slosh::reports
