// The subcommand gate: runs what a campaign still needs, prints each gate row and what has moved
// since the baseline, and leaves gate/junit.xml and gate.md.

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "verification/baseline/baseline_diff.hpp"
#include "verification/baseline/baseline_ledger.hpp"
#include "verification/cli/campaign/earlier_verdicts.hpp"
#include "verification/cli/campaign/gate_files.hpp"
#include "verification/cli/campaign/printed_headline.hpp"
#include "verification/files/protected_inputs.hpp"
#include "verification/texts/campaign_text.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

// Prints what has changed since the baseline.
void print_changes(const GateFindings& findings, const fs::path& ledger) {
  if (!findings.has_baseline) {
    print_lines(
        fmt::format("no baseline    {} is not there: nothing is compared with earlier figures; "
                    "`slosh baseline propose --new` and `approve --new` begin one\n",
                    ledger.string()));
    return;
  }
  for (const RowMovement& movement : findings.movements)
    if (movement.has_changed())
      print_lines(fmt::format("{:<14} {}: {}\n",
                              movement.lost()   ? "lost"
                              : movement.before ? "moved"
                                                : "new",
                              movement.row, movement_text(movement)));
}

bool loses_validation(const std::vector<RowMovement>& movements) {
  return std::any_of(movements.begin(), movements.end(),
                     [](const RowMovement& one) { return one.loses_validation(); });
}

struct GateStart {
  const CampaignOptions& options;
  const Installation& installation;
  const std::atomic<bool>& stop;
  EarlierVerdicts& earlier;
};

// The exit status of the rows, or that of an inconclusive one where all hold and one of validation
// is lost.
int status_of(const AssessedCampaign& assessed, const std::vector<RowMovement>& movements) {
  const int judged = exit_status(assessed.cases, assessed.problems);
  return judged == exit_pass && loses_validation(movements) ? exit_inconclusive : judged;
}

int judge_campaign(RequestedCampaign campaign, const fs::path& ledger, const GateStart& start) {
  // Read before a program of the user's starts.
  const std::vector<Approval> approvals = read_ledger(ledger);
  const Baseline baseline = baseline_of(approvals);
  start.earlier.begin({std::string("gate/") + junit_name, std::string("gate/") + gate_page_name});
  const AssessedCampaign assessed = assess(std::move(campaign), start.stop);
  JudgedCampaign judged{assessed.cases, assessed.problems};
  if (const RunSelection& selection = start.options.selection; selection.is_partial())
    judged.selects = [&selection](const CaseDefinition& of, const RunDefinition& run) {
      return is_selected(selection, of, run);
    };
  GateFindings findings{.movements = movements(baseline, judged),
                        .has_baseline = !approvals.empty(),
                        .inconclusive_passes = start.options.inconclusive_exit == exit_pass};
  findings.status = status_of(assessed, findings.movements);
  start.earlier.judged(findings.status);
  // A lost row is not inconclusive: only an approval takes it out.
  const int asked = loses_validation(findings.movements)
                        ? findings.status
                        : requested_exit(findings.status, start.options);
  std::cerr << complaints(assessed.cases, assessed.problems);
  print_lines(gate_lines(assessed.cases, assessed.problems));
  print_changes(findings, ledger);
  const fs::path directory = assessed.output / "gate";
  reports::GateDocument document = gate_document(assessed, findings, start.installation.source);
  document.exit_status = asked;
  write_gate_files(document, directory);
  print_lines(fmt::format(
      "{}\n{}\ngate: {}, junit.xml\n{}{}", headline_text(assessed, findings.status), document.basis,
      (directory / "gate.md").string(), document.speed, document.speed.empty() ? "" : "\n"));
  start.earlier.end("report", findings.status, asked);
  return asked;
}

int gate_campaign(const GateStart& start) {
  RequestedCampaign campaign = requested(start.options, start.installation);
  const fs::path ledger = ledger_of(start.options, campaign.definition, start.installation);
  for (const fs::path& file : {ledger, head_of(ledger)}) protect_input(file);
  return judge_campaign(std::move(campaign), ledger, start);
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
        return superseding(options, tree.installation, tree.stop, [&](EarlierVerdicts& earlier) {
          return gate_campaign({options, tree.installation, tree.stop, earlier});
        });
      });
  add_selection_options(*gate, gate_options->selection);
  add_inconclusive_option(*gate, *gate_options);
  add_launch_options(*gate, *gate_options);
  add_ledger_option(*gate, *gate_options);
}

}  // namespace slosh
