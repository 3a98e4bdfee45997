// The table of the observed orders of convergence (observed_order.hpp).
#pragma once

#include <optional>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"

namespace slosh {

// Of each scheme that runs unchanged at three or more spacings, and is compared with theory or a
// record there: errors and orders. Nothing where there is no such scheme.
std::optional<reports::Table> order_table(const CaseAssessment& assessment);

}  // namespace slosh
