#include "verification/campaign_command.hpp"

#include <fmt/format.h>

#include <iostream>

#include "reports/write_report.hpp"
#include "verification/baseline/baseline_diff.hpp"
#include "verification/baseline/baseline_figures.hpp"
#include "verification/campaign/campaign_report.hpp"
#include "verification/campaign/problem_run.hpp"
#include "verification/case_file/campaign_parser.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/case_file/problem_table.hpp"
#include "verification/gate_files.hpp"
#include "verification/named_paths.hpp"
#include "verification/problems/problem.hpp"
#include "verification/runs/run_case.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

std::string gate_line(const CaseAssessment& assessment, const GateOutcome& outcome) {
  return fmt::format("{:<14} {} {} {} {} {}: {}", verdict_name(outcome.verdict),
                     assessment.definition.name, outcome.row.candidate, outcome.row.mode,
                     metric_name(outcome.row.metric), outcome.row.quantity, outcome.message);
}

void print(const CaseAssessment& assessment) {
  for (const auto& [run, status] : assessment.runs.status)
    if (status.state == RunState::failed || status.state == RunState::missing ||
        status.state == RunState::not_supplied)
      std::cerr << fmt::format("{}/{}: {}: {}\n", assessment.definition.name, run,
                               state_name(status.state), status.message);
  for (const GateOutcome& outcome : assessment.gate)
    std::cout << gate_line(assessment, outcome) << "\n";
}

void print(const ProblemAssessment& assessment) {
  if (!assessment.run.result)
    std::cerr << fmt::format("{}: {}: {}\n", assessment.definition.name,
                             state_name(assessment.run.status.state),
                             assessment.run.status.message);
  for (const ProblemGateOutcome& outcome : assessment.gate)
    std::cout << fmt::format("{:<14} {} {} {}: {}\n", verdict_name(outcome.verdict),
                             assessment.definition.name, metric_name(outcome.row.metric),
                             outcome.row.measure, outcome.message);
}

void require_window(const CaseDefinition& definition) try {
  require_resolved({definition.window_begin, definition.window_end}, fitted_modes(definition));
} catch (const ComparisonError& error) {
  throw CaseFileError(fmt::format("{}: comparison: {}", definition.file.string(), error.what()));
}

// All that a campaign's cases get wrong is found before anything runs.
std::vector<CaseDefinition> read_cases(const CampaignDefinition& campaign,
                                       const fs::path& experiments) {
  std::vector<CaseDefinition> cases;
  for (const fs::path& file : campaign.cases) {
    CaseDefinition definition = read_case(file, experiments);
    for (const CaseDefinition& other : cases)
      if (other.name == definition.name)
        throw CaseFileError(fmt::format("{}: name = \"{}\": expected a name other than that of {}",
                                        file.string(), definition.name, other.file.string()));
    require_window(definition);
    for (const RunDefinition& run : definition.runs) require_runnable(definition, run);
    cases.push_back(std::move(definition));
  }
  return cases;
}

void print(const AssessedCampaign& assessed) {
  for (const CaseAssessment& one : assessed.cases) print(one);
  for (const ProblemAssessment& one : assessed.problems) print(one);
}

std::string word_for(int status) {
  return status == exit_pass ? "PASS" : status == exit_inconclusive ? "INCONCLUSIVE" : "FAIL";
}

// As the user wants inconclusive rows to end.
int ended(const AssessedCampaign& assessed, const CampaignOptions& options) {
  const int status = exit_status(assessed.cases, assessed.problems);
  return status == exit_inconclusive ? options.inconclusive_exit : status;
}

std::string form_of(const CampaignOptions& options) { return options.quick ? "-quick" : ""; }

}  // namespace

AssessedCampaign assess_campaign(const CampaignOptions& options, const Installation& installation,
                                 const std::atomic<bool>& stop) {
  AssessedCampaign assessed{
      .definition = read_campaign(find_campaign(options.campaign, installation.campaigns),
                                  installation.cases, known_problems()),
      .output = {},
      .cases = {},
      .problems = {}};
  const fs::path experiments = whole(options.experiments);
  const std::vector<CaseDefinition> cases = read_cases(assessed.definition, experiments);
  assessed.output =
      fs::absolute(options.output.empty() ? installation.build / "campaigns" /
                                                (assessed.definition.name + form_of(options))
                                          : options.output);
  const CampaignSettings settings{assessed.output,
                                  installation.executable,
                                  installation.solver_build,
                                  installation.problem_build,
                                  installation.openfoam_templates,
                                  experiments,
                                  options.quick,
                                  options.solve,
                                  options.at_once};
  std::vector<ProblemRun> problem_runs = run_problems(assessed.definition.problems, settings, stop);
  std::vector<CaseRuns> runs = run_cases(cases, settings, stop);
  for (std::size_t i = 0; i < cases.size(); ++i)
    assessed.cases.push_back(assess(cases[i], std::move(runs[i])));
  for (std::size_t i = 0; i < problem_runs.size(); ++i)
    assessed.problems.push_back(
        assess(assessed.definition.problems[i], std::move(problem_runs[i])));
  return assessed;
}

fs::path ledger_of(const CampaignOptions& options, const CampaignDefinition& campaign,
                   const Installation& installation) {
  return options.ledger.empty()
             ? installation.baselines / (campaign.name + form_of(options) + ".jsonl")
             : options.ledger;
}

int run_campaign(const CampaignOptions& options, const Installation& installation,
                 const std::atomic<bool>& stop) {
  const AssessedCampaign assessed = assess_campaign(options, installation, stop);
  print(assessed);
  const std::string command = fmt::format(
      "./slosh campaign {}{}{}", name_or_path(assessed.definition.file, installation.campaigns),
      options.quick ? " --quick" : "", experiments_option(whole(options.experiments)));
  const fs::path report = assessed.output / "report";
  reports::Report content = campaign_report(assessed.definition, options.quick, command,
                                            assessed.cases, assessed.problems);
  add_baseline_figures(read_ledger(ledger_of(options, assessed.definition, installation)),
                       assessed.cases, content);
  reports::write_report(content, report);
  std::cout << word_for(exit_status(assessed.cases, assessed.problems)) << ": "
            << verdict_sentence(assessed.cases, assessed.problems)
            << "\nreport: " << (report / "index.html").string() << "\n";
  return ended(assessed, options);
}

int gate_campaign(const CampaignOptions& options, const Installation& installation,
                  const std::atomic<bool>& stop) {
  const AssessedCampaign assessed = assess_campaign(options, installation, stop);
  const std::vector<RowMovement> moved =
      movements(baseline_of(read_ledger(ledger_of(options, assessed.definition, installation))),
                assessed.cases);
  print(assessed);
  for (const RowMovement& movement : moved)
    if (movement.before && movement.has_changed())
      std::cout << fmt::format("moved          {}: {}\n", movement.row, movement_text(movement));
  const fs::path directory = assessed.output / "gate";
  write_gate_files(gate_document(assessed, moved, installation.source), directory);
  std::cout << word_for(exit_status(assessed.cases, assessed.problems)) << ": "
            << verdict_sentence(assessed.cases, assessed.problems)
            << "\ngate: " << (directory / "gate.md").string() << ", junit.xml, gate.sarif\n";
  return ended(assessed, options);
}

}  // namespace slosh
