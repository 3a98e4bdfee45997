// Whether a report keeps to its model, before anything is written.
#pragma once

#include "reports/report_model.hpp"

namespace slosh::reports {

// Throws ReportError, naming the section, table or figure, for an id that is unfit or taken,
// columns or samples of unequal number, an x_range that no axis can show, or results_json that is
// not JSON.
void check_report(const Report& report);

}  // namespace slosh::reports
