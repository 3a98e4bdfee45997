// The sections of a report as data of the HTML templates.
#pragma once

#include <kainjow/mustache.hpp>
#include <vector>

#include "reports/drawing/draw_figure.hpp"
#include "reports/fields/draw_field.hpp"
#include "reports/model/report_model.hpp"
#include "reports/pages/page_links.hpp"

namespace slosh::reports {

// What was drawn of a report: one for each figure and for each field, in the report's order.
struct Drawings {
  std::vector<DrawnFigure> figures;
  std::vector<DrawnField> fields;
};

// One for each section, in the report's order. Tables and figures are numbered through the whole
// report. A section's heading is of the level 2, and 3 where the whole report is one document.
std::vector<kainjow::mustache::data> sections_data(const Report& report, const Drawings& drawings,
                                                   Layout layout);

}  // namespace slosh::reports
