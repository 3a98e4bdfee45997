#include "verification/cli/campaign/campaign_command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>

#include "reports/model/side_by_side.hpp"
#include "reports/pages/print_pdf.hpp"
#include "reports/pages/write_report.hpp"
#include "reports/summary/campaign_report.hpp"
#include "sph/threads.hpp"
#include "verification/assessment/row_kinds.hpp"
#include "verification/baseline/baseline_diff.hpp"
#include "verification/baseline/baseline_figures.hpp"
#include "verification/campaign/known_drawings.hpp"
#include "verification/cli/campaign/cached_verdict.hpp"
#include "verification/cli/campaign/gate_files.hpp"
#include "verification/cli/campaign/requested_campaign.hpp"
#include "verification/cli/named_paths.hpp"
#include "verification/files/atomic_file.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/sensitivity/case_coverage.hpp"
#include "verification/sensitivity/known_strengths.hpp"
#include "verification/texts/assessment_text.hpp"
#include "verification/texts/campaign_plan_text.hpp"
#include "verification/texts/verdict_text.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

// What --resume promises: a name that is mistyped starts nothing from the beginning. And --pdf: no
// campaign runs for hours to a report that cannot be printed.
void require_possible(const CampaignOptions& options, const CampaignSettings& settings) {
  if (options.resume && !fs::exists(settings.output / "jobs"))
    throw CaseFileError(fmt::format("--resume: expected an earlier start of this campaign in {}",
                                    settings.output.string()));
  if (options.pdf && !reports::can_print_pdf())
    throw CaseFileError("--pdf: " + reports::no_browser_message());
}

// Nothing of it would come out otherwise if it were tried again.
bool is_settled(const AssessedCampaign& assessed) {
  const auto settled = [](const RunStatus& status) {
    return status.state != RunState::failed && status.state != RunState::missing;
  };
  for (const CaseAssessment& one : assessed.cases)
    for (const auto& [run, status] : one.runs.status)
      if (!settled(status)) return false;
  return std::all_of(assessed.problems.begin(), assessed.problems.end(),
                     [&](const ProblemAssessment& one) { return settled(one.run.status); });
}

fs::path page_in(const fs::path& place) { return place / "report/index.html"; }
fs::path pdf_in(const fs::path& place) { return place / "report/report.pdf"; }

bool report_stands(const fs::path& place, const CampaignOptions& options) {
  return fs::exists(page_in(place)) && (!options.pdf || fs::exists(pdf_in(place)));
}

std::string report_lines(const fs::path& place, const CampaignOptions& options) {
  return "report: " + page_in(place).string() + "\n" +
         (options.pdf ? "PDF: " + pdf_in(place).string() + "\n" : "");
}

// What a report needs to know beside the assessment.
struct ReportSources {
  fs::path ledger;
  std::string campaign;  // as a command line names it
  std::string judge;     // the content of this program
};

void leave_report(const AssessedCampaign& assessed, const CampaignOptions& options,
                  const ReportSources& sources) {
  const std::string command =
      fmt::format("./slosh campaign {}{}{}", sources.campaign, selection_options(options.selection),
                  experiments_option(whole(options.experiments)));
  KnownStrengths known(assessed.output / "strengths.json", sources.judge);
  reports::Report report = campaign_report(assessed.definition, options.selection.quick, command,
                                           assessed.cases, assessed.problems, &known);
  known.write();
  add_baseline_figures(read_ledger(sources.ledger), assessed.cases, report);
  KnownDrawings drawings(assessed.output / "drawings");
  reports::write_report(report, assessed.output / "report",
                        {.pdf = options.pdf,
                         .threads = sph::usable_cores(),
                         .gnuplot = [&](const auto& script, const auto& id, const auto& scratch) {
                           return drawings.draw(script, id, scratch);
                         }});
  drawings.write();
}

// The verdicts as a table, where one is asked for.
void leave_table(const AssessedCampaign& assessed, const std::vector<RowMovement>& moved,
                 const CampaignOptions& options, const fs::path& source) {
  if (options.csv.empty()) return;
  replace_file(options.csv, reports::gate_csv(gate_document(assessed, moved, source)),
               Durability::process_crash);
}

AssessedCampaign assess(RequestedCampaign campaign, const std::atomic<bool>& stop) {
  CampaignRuns runs =
      run_campaign_jobs(campaign.cases, campaign.definition.problems, campaign.settings, stop);
  AssessedCampaign assessed{std::move(campaign.definition), campaign.place, {}, {}};
  assessed.cases.resize(campaign.cases.size());
  reports::side_by_side(campaign.cases.size(), sph::usable_cores(), [&](std::size_t i) {
    assessed.cases[i] = assess(campaign.cases[i], std::move(runs.cases[i]));
  });
  for (std::size_t i = 0; i < runs.problems.size(); ++i)
    assessed.problems.push_back(
        assess(assessed.definition.problems[i], std::move(runs.problems[i])));
  return assessed;
}

// On standard output.
void tell(const std::string& text) { std::cout << as_shown(text, style_of(STDOUT_FILENO)); }

// As the user wants inconclusive rows to end.
int ended(int status, const CampaignOptions& options) {
  return status == exit_inconclusive ? options.inconclusive_exit : status;
}

}  // namespace

AssessedCampaign assess_campaign(const CampaignOptions& options, const Installation& installation,
                                 const std::atomic<bool>& stop) {
  return assess(requested(options, installation), stop);
}

fs::path ledger_of(const CampaignOptions& options, const CampaignDefinition& campaign,
                   const Installation& installation) {
  if (!options.ledger)
    return installation.baselines / (campaign.name + form_of(options) + ".jsonl");
  if (!options.new_ledger && !holds_approvals(*options.ledger))
    throw CaseFileError(
        fmt::format("--ledger: '{}' holds no approval; expected the path of a ledger, or `slosh "
                    "baseline approve --new` to begin one there",
                    options.ledger->string()));
  return *options.ledger;
}

int run_campaign(const CampaignOptions& options, const Installation& installation,
                 const std::atomic<bool>& stop) {
  RequestedCampaign campaign = requested(options, installation);
  require_possible(options, campaign.settings);
  if (options.dry_run) {
    std::cout << plan_text(campaign.cases, campaign.definition.problems, campaign.settings);
    return exit_pass;
  }
  const fs::path place = campaign.place,
                 ledger = ledger_of(options, campaign.definition, installation);
  const auto fingerprint = [cases = campaign.cases, settings = campaign.settings,
                            definition = campaign.definition,
                            judges = judges_of(campaign.settings, ledger)] {
    return fingerprint_of(definition, cases, settings, judges);
  };
  if (const auto cached = read_cached_verdict(place); options.csv.empty() && cached &&
                                                      report_stands(place, options) &&
                                                      cached->fingerprint == fingerprint()) {
    tell(cached->out);
    return ended(cached->status, options);
  }
  const std::string judge = content_hash(read_bytes(campaign.settings.executable));
  const AssessedCampaign assessed = assess(std::move(campaign), stop);
  std::cerr << complaints(assessed.cases, assessed.problems);
  const std::string rows = gate_lines(assessed.cases, assessed.problems);
  tell(rows);
  forget_cached_verdict(place);
  leave_report(assessed, options,
               {ledger, name_or_path(assessed.definition.file, installation.campaigns), judge});
  leave_table(assessed, movements(baseline_of(read_ledger(ledger)), assessed.cases), options,
              installation.source);
  const int status = exit_status(assessed.cases, assessed.problems);
  const std::string verdict = fmt::format(
      "{}: {}{}\n{}\n{}", headline_word(status),
      verdict_sentence(assessed.cases, assessed.problems), coverage_sentence(assessed.cases),
      kinds_sentence(assessed.cases, assessed.problems), report_lines(place, options));
  tell(verdict);
  if (const auto now = fingerprint(); now && is_settled(assessed))
    write_cached_verdict({*now, status, rows + verdict}, place);
  return ended(status, options);
}

int gate_campaign(const CampaignOptions& options, const Installation& installation,
                  const std::atomic<bool>& stop) {
  RequestedCampaign campaign = requested(options, installation);
  const fs::path ledger = ledger_of(options, campaign.definition, installation);
  const Baseline baseline = baseline_of(read_ledger(ledger));
  const AssessedCampaign assessed = assess(std::move(campaign), stop);
  const std::vector<RowMovement> moved = movements(baseline, assessed.cases);
  std::cerr << complaints(assessed.cases, assessed.problems);
  tell(gate_lines(assessed.cases, assessed.problems));
  if (!holds_approvals(ledger))
    tell(fmt::format(
        "no baseline    {} is not there: nothing is compared with earlier figures; `slosh baseline "
        "propose --new` and `approve --new` begin one\n",
        ledger.string()));
  for (const RowMovement& movement : moved)
    if (movement.before && movement.has_changed())
      tell(fmt::format("moved          {}: {}\n", movement.row, movement_text(movement)));
  const fs::path directory = assessed.output / "gate";
  write_gate_files(gate_document(assessed, moved, installation.source), directory);
  leave_table(assessed, moved, options, installation.source);
  tell(fmt::format(
      "{}: {}{}\n{}\ngate: {}, junit.xml, gate.sarif\n",
      headline_word(exit_status(assessed.cases, assessed.problems)),
      verdict_sentence(assessed.cases, assessed.problems), coverage_sentence(assessed.cases),
      kinds_sentence(assessed.cases, assessed.problems), (directory / "gate.md").string()));
  return ended(exit_status(assessed.cases, assessed.problems), options);
}

}  // namespace slosh
