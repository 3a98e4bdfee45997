// How the gate's values have moved from approval to approval of a campaign's ledger, and now.
#pragma once

#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"
#include "verification/baseline/baseline_ledger.hpp"

namespace slosh {

// Adds to the section of each case (its id is the case's name) one figure of those of its rows that
// are nearest to their tolerance or furthest beyond it now: where in the tolerance of its time each
// value stood, 0 its middle and 1 and -1 its ends, at each approval and now. Without an approval,
// and of a case of which the ledger has no row, there is none. Throws LedgerError as baseline_of().
void add_baseline_figures(const std::vector<Approval>& approvals,
                          const std::vector<CaseAssessment>& cases, reports::Report& report);

}  // namespace slosh
