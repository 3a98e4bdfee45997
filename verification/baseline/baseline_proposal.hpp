// A proposal: the changes that would make a campaign's present figures its baseline. It lies beside
// the results until somebody approves it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/baseline/baseline_diff.hpp"
#include "verification/baseline/baseline_ledger.hpp"

namespace slosh {

struct Proposal {
  std::string campaign;
  std::vector<BaselineChange> changes;
};

// Of the rows that have changed. A row that has lost its value keeps its baseline: what could not
// be measured is no new figure. One that the campaign no longer declares goes.
std::vector<BaselineChange> proposed_changes(const std::vector<RowMovement>& movements);

// Both throw LedgerError.
void write_proposal(const Proposal& proposal, const std::filesystem::path& file);
Proposal read_proposal(const std::filesystem::path& file);

}  // namespace slosh
