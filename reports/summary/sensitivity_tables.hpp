// The tables of a case's gate sensitivity: the spoilings that each row detects, and those that the
// rows detect together.
#pragma once

#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/sensitivity/case_coverage.hpp"
#include "verification/sensitivity/gate_sensitivity.hpp"

namespace slosh {

// One line per row, one column per spoiling.
reports::Table sensitivity_table(const CaseAssessment& assessment,
                                 const std::vector<RowSensitivity>& sensitivity);

// One line per case, one column per required detection.
reports::Table coverage_table(const std::string& id, const std::vector<CaseCoverage>& cases);

}  // namespace slosh
