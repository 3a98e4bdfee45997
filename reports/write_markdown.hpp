// The report as GitHub-flavoured Markdown, its figures linked as figures/<id>.svg.
#pragma once

#include <string>

#include "reports/report_model.hpp"

namespace slosh::reports {

std::string markdown_page(const Report& report);

}  // namespace slosh::reports
