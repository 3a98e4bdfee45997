// The report as GitHub-flavoured Markdown, its figures linked as figures/<id>.svg, its fields as
// figures/<id>.png.
#pragma once

#include <string>

#include "reports/model/report_model.hpp"

namespace slosh::reports {

std::string markdown_page(const Report& report);

}  // namespace slosh::reports
