// Whether a report keeps to its model, before anything is written.
#pragma once

#include "reports/model/report_model.hpp"

namespace slosh::reports {

// Throws ReportError, naming the page, section, table or figure, for an id that is unfit or taken,
// a section on a page that there is not, a page without a section, a link that leads nowhere,
// columns or samples of unequal number, a range that no axis or colour bar can show, a field
// without panels or with sizes that nothing can be drawn in, or results_json that is not JSON.
void check_report(const Report& report);

}  // namespace slosh::reports
