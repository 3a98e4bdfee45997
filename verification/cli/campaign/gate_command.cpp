// The subcommand gate: runs what a campaign still needs, prints each gate row and what has moved
// since the baseline, and leaves gate/junit.xml and gate.md. With --selftest it tests on a
// campaign's own results what its gate rows detect, and starts no solver.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>

#include "reports/summary/report_sections.hpp"
#include "verification/baseline/baseline_diff.hpp"
#include "verification/baseline/baseline_ledger.hpp"
#include "verification/cli/campaign/earlier_verdicts.hpp"
#include "verification/cli/campaign/gate_files.hpp"
#include "verification/cli/texts/campaign_text.hpp"
#include "verification/files/protected_inputs.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/sensitivity/case_coverage.hpp"

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
  print_lines(changed_lines(findings.movements));
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

// Returns a row of the table as a line: its name, then each value after its heading.
std::string line_of(const reports::Table& table, const std::vector<std::string>& row) {
  std::vector<std::string> parts;
  for (std::size_t i = 1; i < row.size(); ++i)
    if (!row[i].empty()) parts.push_back(fmt::format("{}: {}", table.header[i], row[i]));
  return fmt::format("{}: {}\n", row.front(), fmt::join(parts, ", "));
}

void print(const reports::Table& table) {
  for (const std::vector<std::string>& row : table.rows) std::cout << line_of(table, row);
}

struct Found {
  std::size_t tried = 0;
  std::vector<std::string> blind;  // rows
  std::vector<CaseCoverage> cases;

  std::size_t missed() const {
    return static_cast<std::size_t>(std::count_if(
        cases.begin(), cases.end(), [](const CaseCoverage& one) { return !one.missed().empty(); }));
  }
};

Found test(const AssessedCampaign& assessed) {
  Found found;
  for (const CaseAssessment& one : assessed.cases) {
    const std::vector<RowSensitivity> sensitivity = gate_sensitivity(one);
    std::cout << one.definition.name << ":\n";
    print(sensitivity_table(one, sensitivity));
    for (const RowSensitivity& row : sensitivity) found.tried += row.detects.size();
    for (const std::string& row : blind_rows(sensitivity))
      found.blind.push_back(one.definition.name + ": " + row);
    found.cases.push_back(case_coverage(one, sensitivity));
  }
  return found;
}

// Returns the cases with selected runs.
std::vector<CaseCoverage> selected(const AssessedCampaign& assessed,
                                   std::vector<CaseCoverage> cases) {
  std::vector<CaseCoverage> kept;
  for (std::size_t i = 0; i < cases.size(); ++i)
    if (has_selected_runs(assessed.cases[i])) kept.push_back(std::move(cases[i]));
  return kept;
}

// Prints what each row detects, and what the rows of each case detect together. Returns
// exit_violated if a row passes with a truncated series or NaN, or if the rows of a case together
// miss what every case must detect (with --only or --tag the latter is printed but does
// not count), and exit_not_compared if no row could be tried. Throws CaseFileError if a part of a
// campaign is to be recorded.
int selftest_campaign(const CampaignOptions& options, bool records,
                      const Installation& installation) {
  const RunSelection& selection = options.selection;
  const bool is_whole = selection.only.empty() && selection.tags.empty();
  if (records && !is_whole)
    throw CaseFileError("--record: expected a whole campaign, without --only and --tag");
  const AssessedCampaign assessed = assess_present(options, installation);
  Found found = test(assessed);
  found.cases = selected(assessed, std::move(found.cases));
  std::cout << "Together:\n";
  print(coverage_table("coverage", found.cases));
  for (const std::string& row : found.blind) std::cout << "BLIND " << row << "\n";
  if (records) {
    const std::string& name = assessed.definition.name;
    const auto file = selftest_record_file(baselines_of(assessed.definition, installation), name,
                                           selection.quick);
    write_selftest_record({name, selection.quick, found.cases}, file);
    std::cout << "record: " << file.string() << "\n";
  }
  const bool holds = found.blind.empty() && (found.missed() == 0 || !is_whole);
  std::cout << fmt::format(
      "{}: {} spoilings were tried, {} of NaN or a truncated series were let pass; the rows of {} "
      "of {} cases miss "
      "what every case must detect\n",
      holds && found.tried > 0 ? "PASS" : "FAIL", found.tried, found.blind.size(), found.missed(),
      found.cases.size());
  if (found.tried == 0) return exit_not_compared;
  return holds ? exit_pass : exit_violated;
}

}  // namespace

void add_gate_command(const CommandTree& tree) {
  struct SelftestOptions {
    bool asked = false;
    bool record = false;  // write the findings beside the baselines (case_coverage.hpp)
  };
  const auto selftest = std::make_shared<SelftestOptions>();
  const auto [command, options] = add_command_on_campaign(
      tree,
      {"gate",
       "Runs what a campaign still needs, prints what has changed since its baseline, and writes "
       "junit.xml and gate.md",
       {"./slosh gate " + std::string(example_run) + " --inconclusive-exit 0",
        "./slosh gate --selftest " + std::string(example_run)}},
      [tree, selftest](const CampaignOptions& given, const Installation& installation) {
        if (selftest->asked) return selftest_campaign(given, selftest->record, installation);
        tree.stop_on_signals();
        return superseding(given, installation, tree.stop, [&](EarlierVerdicts& earlier) {
          return gate_campaign({given, installation, tree.stop, earlier});
        });
      });
  add_start_options(command, options);
  add_ledger_option(command, options);
  CLI::Option* asked = command.add_flag(
      "--selftest", selftest->asked,
      "Only spoil each candidate on purpose, on the results that are there, and test whether the "
      "rows of each case together detect what every case must detect");
  for (const char* other : {"--inconclusive-exit", "--jobs", "--launcher", "--timings", "--ledger"})
    asked->excludes(command.get_option(other));
  command
      .add_flag("--record", selftest->record,
                "Write the findings to verification/baselines/NAME.selftest.json, with -quick "
                "after the NAME of a quick form")
      ->needs(asked);
}

}  // namespace slosh
