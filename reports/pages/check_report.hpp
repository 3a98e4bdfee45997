// Checks a report against its model before anything is written.
#pragma once

#include "reports/model/report_model.hpp"

namespace slosh::reports {

// Throws ReportError, which names the page, section, table or figure, for an id that is invalid or
// used twice, a section on a page that does not exist, a page without a section, a broken link,
// columns or samples of unequal number, a range that no axis or colour bar can show, a field
// without panels, with more in a row than fit, or with sizes that are not positive, and
// results_json that is not JSON.
void check_report(const Report& report);

}  // namespace slosh::reports
