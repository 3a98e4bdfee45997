// The subcommand baseline: what has moved since a campaign's baseline, a proposal to make the
// present figures the new one, and its approval. Starts no solver.

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "verification/baseline/baseline_diff.hpp"
#include "verification/baseline/baseline_ledger.hpp"
#include "verification/cli/campaign/requested_campaign.hpp"
#include "verification/files/foreign/legible_text.hpp"
#include "verification/files/protected_inputs.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/results/provenance.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

struct MovedRows {
  std::string campaign;
  fs::path ledger, proposal;
  std::vector<RowMovement> moved;
  int status;  // of the present results
};

// Checks the ledger before anything is judged.
fs::path checked_ledger(const CampaignOptions& options, const Installation& installation) {
  fs::path ledger = ledger_of(options, requested(options, installation).definition, installation);
  if (options.new_ledger && holds_approvals(ledger))
    throw CaseFileError(
        fmt::format("--new: '{}' is there already; expected a ledger that is not there, or, if it "
                    "is one, no --new",
                    ledger.string()));
  if (!options.new_ledger && !holds_approvals(ledger))
    throw CaseFileError(
        fmt::format("the baselines' ledger {} is not there; expected one, or --new to begin it",
                    ledger.string()));
  return ledger;
}

MovedRows moved_rows(const CampaignOptions& options, const Installation& installation) {
  const fs::path ledger = checked_ledger(options, installation);
  const AssessedCampaign assessed = assess_present(options, installation);
  return {assessed.definition.name + (options.selection.quick ? " (quick form)" : ""), ledger,
          assessed.output / "baseline_proposal.json",
          movements(baseline_of(read_ledger(ledger)), {assessed.cases, assessed.problems}),
          exit_status(assessed.cases, assessed.problems)};
}

struct ApprovalOptions {
  std::string who, reason;
};

// Prints what has changed. Returns exit_violated if anything has.
int diff_baseline(const CampaignOptions& options, const Installation& installation) {
  const MovedRows now = moved_rows(options, installation);
  print_lines(changed_lines(now.moved));
  const auto changed = std::ranges::count_if(now.moved, &RowMovement::has_changed);
  std::cout << fmt::format("{} of {} rows have changed since the baseline {}\n", changed,
                           now.moved.size(), now.ledger.string());
  return changed == 0 ? exit_pass : exit_violated;
}

// Writes <output>/baseline_proposal.json, unless nothing has changed. Results that are not there
// are no reason why it has not.
int propose_baseline(const CampaignOptions& options, const Installation& installation) {
  const MovedRows now = moved_rows(options, installation);
  print_lines(changed_lines(now.moved));
  const Proposal proposal{now.campaign, proposed_changes(now.moved)};
  if (proposal.changes.empty()) {
    std::cout << "nothing to propose: "
              << (options.new_ledger ? "no row has a value, and there is no baseline\n"
                                     : "the baseline stands\n");
    const bool has_results = now.status != exit_solver_failed && now.status != exit_not_compared;
    return has_results ? exit_pass : now.status;
  }
  for (const fs::path& file : {now.ledger, head_of(now.ledger)}) protect_input(file);
  write_proposal(proposal, now.proposal);
  std::cout << "proposal: " << now.proposal.string() << "\n";
  return exit_pass;
}

// Appends the proposal to the ledger. Throws LedgerError if there is no proposal, or if the results
// have changed since it was made.
int approve_baseline(const CampaignOptions& options, const ApprovalOptions& approval,
                     const Installation& installation) {
  const MovedRows now = moved_rows(options, installation);
  const Proposal proposal = read_proposal(now.proposal);
  if (proposal.changes != proposed_changes(now.moved))
    throw LedgerError(now.proposal.string() +
                      ": the results or the baseline have changed since it was made; expected a "
                      "proposal of what stands, by `slosh baseline propose`");
  protect_input(now.proposal);
  append_approval({now.campaign, provenance("").at("date_utc"), approval.who, approval.reason,
                   proposal.changes},
                  now.ledger);
  fs::remove(now.proposal);
  std::cout << fmt::format("{} changes approved: {}\n", proposal.changes.size(),
                           now.ledger.string());
  return exit_pass;
}

}  // namespace

void add_baseline_commands(const CommandTree& tree) {
  CLI::App& baseline = *tree.app.add_subcommand(
      "baseline", "The earlier results of a campaign, and what has changed since");
  baseline.require_subcommand(1);
  const CommandTree below{baseline, tree.installation, tree.stop, tree.stop_on_signals,
                          tree.action};
  const std::string example = " verification -o wave --ledger wave.jsonl --new";
  const auto add = [&](const char* name, const char* description, const std::string& more,
                       auto command) {
    const auto [added, options] = add_command_on_campaign(
        below, {name, description, {std::string("./slosh baseline ") + name + example + more}},
        command);
    add_ledger_option(added, options);
    added.add_flag("--new", options.new_ledger, "Begin a ledger that is not there yet");
    return &added;
  };
  add("diff", "Prints what has changed; exit status 1 if anything has", "", diff_baseline);
  add("propose", "Writes a proposal to make the present results the baseline", "",
      propose_baseline);
  auto approval = std::make_shared<ApprovalOptions>();
  CLI::App* approve =
      add("approve", "Adds the proposal to the ledger",
          " --who 'A. Name' --reason 'The first figures.'",
          [approval](const CampaignOptions& options, const Installation& installation) {
            return approve_baseline(options, *approval, installation);
          });
  // Takes out what no terminal should get, as of all texts of others.
  const CLI::Validator printed(
      [](std::string& text) {
        text = legible(text);
        return !text.empty() && text.find("\uFFFD") == text.npos
                   ? std::string()
                   : legible_message(text) + ": expected a text in UTF-8";
      },
      "");
  approve->add_option("--who", approval->who, "Who approves it")->required()->transform(printed);
  approve->add_option("--reason", approval->reason, "Why the results may change")
      ->required()
      ->transform(printed);
}

}  // namespace slosh
