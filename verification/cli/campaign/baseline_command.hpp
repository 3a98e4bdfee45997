// The subcommand baseline: what has moved since a campaign's baseline, a proposal to make the
// present figures the new one, and its approval. Starts no solver.
#pragma once

#include <string>

#include "verification/cli/campaign/campaign_command.hpp"

namespace slosh {

// Prints what has changed. exit_violated where something has.
int diff_baseline(const CampaignOptions& options, const Installation& installation);

// Leaves <output>/baseline_proposal.json, unless nothing has changed.
int propose_baseline(const CampaignOptions& options, const Installation& installation);

struct ApprovalOptions {
  std::string who, reason;
};

// Adds the proposal to the ledger. Throws LedgerError where there is none, or where the results
// have changed since it was made.
int approve_baseline(const CampaignOptions& options, const ApprovalOptions& approval,
                     const Installation& installation);

}  // namespace slosh
