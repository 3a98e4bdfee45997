// What the earlier runs of a campaign left in the store, whose file history/NAME.jsonl
// (NAME-quick for the quick form) has a line for each state of the whole campaign
// (gate_history.hpp).
#pragma once

#include <string>

#include "reports/model/report_model.hpp"
#include "verification/cli/campaign/assessed_campaign.hpp"
#include "verification/results/result_store.hpp"

namespace slosh {

struct CampaignPast {
  ResultStore store{{}};
  std::string name;  // with the suffix of the form
};

// Adds the campaign's present state to the history. Says on standard error why where it cannot.
void keep_state(const AssessedCampaign& assessed, const CampaignPast& past);

// Adds a figure for each run of which a row does not hold and of which the store has an earlier
// result, to the sections of the cases. A history that cannot be read is told on standard error and
// left out.
void add_past(const AssessedCampaign& assessed, const CampaignPast& past, reports::Report& report);

}  // namespace slosh
