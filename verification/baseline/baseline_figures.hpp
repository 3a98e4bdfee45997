// Figures of the gate's values over the approvals of a campaign's ledger.
#pragma once

#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"
#include "verification/baseline/baseline_ledger.hpp"

namespace slosh {

// Adds to the section of each case (its id is the case's name) one figure of the case's rows that
// are closest to their tolerance or furthest beyond it now: the place of each value in the
// tolerance of its time (0 the middle, 1 and -1 the ends), at each approval and now. Adds nothing
// without an approval, or for a case whose rows are not in the ledger. Throws LedgerError as
// baseline_of() does.
void add_baseline_figures(const std::vector<Approval>& approvals,
                          const std::vector<CaseAssessment>& cases, reports::Report& report);

}  // namespace slosh
