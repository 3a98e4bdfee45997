// The subcommand gate: runs what a campaign still needs, prints each gate row and what has moved
// since the baseline, and leaves gate/junit.xml and gate.md.

#include <fmt/format.h>

#include <iostream>

#include "reports/summary/campaign_report.hpp"
#include "verification/assessment/row_kinds.hpp"
#include "verification/baseline/baseline_diff.hpp"
#include "verification/baseline/baseline_ledger.hpp"
#include "verification/cli/campaign/gate_files.hpp"
#include "verification/files/protected_inputs.hpp"
#include "verification/sensitivity/case_coverage.hpp"
#include "verification/texts/assessment_text.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

int gate_campaign(const CampaignOptions& options, const Installation& installation,
                  const std::atomic<bool>& stop) {
  RequestedCampaign campaign = requested(options, installation);
  const fs::path ledger = ledger_of(options, campaign.definition, installation);
  for (const fs::path& file : {ledger, head_of(ledger)}) protect_input(file);
  const fs::path directory = campaign.place / "gate";
  require_gate_places(directory);
  const Baseline baseline = baseline_of(read_ledger(ledger));
  const AssessedCampaign assessed = assess(std::move(campaign), stop);
  const std::vector<RowMovement> moved = movements(baseline, assessed.cases);
  std::cerr << complaints(assessed.cases, assessed.problems);
  print_lines(gate_lines(assessed.cases, assessed.problems));
  if (!holds_approvals(ledger))
    print_lines(
        fmt::format("no baseline    {} is not there: nothing is compared with earlier figures; "
                    "`slosh baseline propose --new` and `approve --new` begin one\n",
                    ledger.string()));
  for (const RowMovement& movement : moved)
    if (movement.before && movement.has_changed())
      print_lines(fmt::format("moved          {}: {}\n", movement.row, movement_text(movement)));
  write_gate_files(gate_document(assessed, moved, installation.source), directory);
  print_lines(fmt::format(
      "{}: {}{}\n{}\ngate: {}, junit.xml\n",
      headline_word(exit_status(assessed.cases, assessed.problems)),
      verdict_sentence(assessed.cases, assessed.problems), coverage_sentence(assessed.cases),
      kinds_sentence(assessed.cases, assessed.problems), (directory / "gate.md").string()));
  return requested_exit(exit_status(assessed.cases, assessed.problems), options);
}

}  // namespace

void add_gate_command(const CommandTree& tree) {
  const auto [gate, gate_options] = add_command_on_campaign(
      tree,
      {"gate",
       "Runs what a campaign still needs, prints what has changed since its baseline, and writes "
       "junit.xml and gate.md",
       {"./slosh gate " + std::string(example_run) + " --inconclusive-exit 0"}},
      [tree](const CampaignOptions& options) {
        tree.stop_on_signals();
        return gate_campaign(options, tree.installation, tree.stop);
      });
  add_selection_options(*gate, gate_options->selection);
  add_inconclusive_option(*gate, *gate_options);
  add_launch_options(*gate, *gate_options);
  add_ledger_option(*gate, *gate_options);
}

}  // namespace slosh
