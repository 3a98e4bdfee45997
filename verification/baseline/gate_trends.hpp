// What the value of each gate row was over the approvals of the campaign's ledger and over the
// campaign's earlier runs: a trend beside each row of the gate tables.
#pragma once

#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"
#include "verification/baseline/baseline_ledger.hpp"
#include "verification/baseline/gate_history.hpp"

namespace slosh {

// Sets the trends of the table "CASE-gate" of each case, whose rows are those of the case's gate. A
// trend holds the latest values, in the order of time, each with its interval and the tolerance of
// its time, and ends with the present one. A row without an earlier value or without a present one
// has none. Throws LedgerError as baseline_of() does.
void add_gate_trends(const std::vector<Approval>& approvals,
                     const std::vector<CampaignState>& history,
                     const std::vector<CaseAssessment>& cases, reports::Report& report);

}  // namespace slosh
