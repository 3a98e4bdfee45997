// What the earlier runs of a campaign left: in the ledger of its approvals, and in the store, whose
// file history/NAME.jsonl (NAME-quick for the quick form) has a line for each state of the whole
// campaign (gate_history.hpp).
#pragma once

#include <filesystem>

#include "reports/model/report_model.hpp"
#include "verification/cli/campaign/assessed_campaign.hpp"
#include "verification/results/result_store.hpp"

namespace slosh {

struct CampaignPast {
  std::filesystem::path ledger;
  ResultStore store{{}};
  std::string name;  // with the suffix of the form
};

// Adds the campaign's present state to the history. Says on standard error why where it cannot.
void keep_state(const AssessedCampaign& assessed, const CampaignPast& past);

// Adds a trend to each gate row, and a figure for each run of which a row does not hold and of
// which the store has an earlier result, to the sections of the cases. A history that cannot be
// read is told on standard error and left out. Throws LedgerError.
void add_past(const AssessedCampaign& assessed, const CampaignPast& past, reports::Report& report);

}  // namespace slosh
