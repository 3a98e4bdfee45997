#include "verification/cli/campaign/baseline_command.hpp"

#include <fmt/format.h>

#include <iostream>

#include "verification/baseline/baseline_diff.hpp"
#include "verification/baseline/baseline_proposal.hpp"
#include "verification/cli/campaign/requested_campaign.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/results/provenance.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

struct MovedRows {
  std::string campaign;
  fs::path ledger, proposal;
  std::vector<RowMovement> moved;
};

// Before anything is judged.
fs::path checked_ledger(const CampaignOptions& options, const Installation& installation) {
  const fs::path ledger =
      ledger_of(options, requested(options, installation).definition, installation);
  if (options.new_ledger && holds_approvals(ledger))
    throw CaseFileError(
        fmt::format("--new: '{}' holds approvals; expected a ledger that is not there, or no --new",
                    ledger.string()));
  if (!options.new_ledger && !holds_approvals(ledger))
    throw CaseFileError(
        fmt::format("the baselines' ledger {} is not there; expected one, or --new to begin it",
                    ledger.string()));
  return ledger;
}

MovedRows moved_rows(CampaignOptions options, const Installation& installation) {
  options.solve = false;
  const fs::path ledger = checked_ledger(options, installation);
  const std::atomic<bool> never{false};
  const AssessedCampaign assessed = assess_campaign(options, installation, never);
  return {assessed.definition.name + (options.selection.quick ? " (quick form)" : ""), ledger,
          assessed.output / "baseline_proposal.json",
          movements(baseline_of(read_ledger(ledger)), assessed.cases)};
}

// How many were told.
std::size_t print_changes(const std::vector<RowMovement>& moved) {
  std::size_t count = 0;
  for (const RowMovement& movement : moved) {
    if (!movement.has_changed()) continue;
    ++count;
    std::cout << movement.row << ": " << movement_text(movement) << "\n";
  }
  return count;
}

}  // namespace

int diff_baseline(const CampaignOptions& options, const Installation& installation) {
  const MovedRows now = moved_rows(options, installation);
  const std::size_t changed = print_changes(now.moved);
  std::cout << fmt::format("{} of {} rows have changed since the baseline {}\n", changed,
                           now.moved.size(), now.ledger.string());
  return changed == 0 ? exit_pass : exit_violated;
}

int propose_baseline(const CampaignOptions& options, const Installation& installation) {
  const MovedRows now = moved_rows(options, installation);
  print_changes(now.moved);
  const Proposal proposal{now.campaign, proposed_changes(now.moved)};
  if (proposal.changes.empty()) {
    std::cout << "nothing to propose: the baseline stands\n";
    return exit_pass;
  }
  write_proposal(proposal, now.proposal);
  std::cout << "proposal: " << now.proposal.string() << "\n";
  return exit_pass;
}

int approve_baseline(const CampaignOptions& options, const ApprovalOptions& approval,
                     const Installation& installation) {
  const MovedRows now = moved_rows(options, installation);
  const Proposal proposal = read_proposal(now.proposal);
  if (proposal.changes != proposed_changes(now.moved))
    throw LedgerError(now.proposal.string() +
                      ": the results or the baseline have changed since it was made; expected a "
                      "proposal of what stands, by `slosh baseline propose`");
  append_approval({now.campaign, provenance("").at("date_utc"), approval.who, approval.reason,
                   proposal.changes},
                  now.ledger);
  fs::remove(now.proposal);
  std::cout << fmt::format("{} changes approved: {}\n", proposal.changes.size(),
                           now.ledger.string());
  return exit_pass;
}

}  // namespace slosh
