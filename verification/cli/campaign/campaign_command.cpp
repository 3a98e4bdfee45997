// The subcommands campaign and report: run a campaign's cases, compare and judge them, and write
// the report; or the same from the results that are there.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

#include "reports/pages/write_report.hpp"
#include "reports/summary/campaign_report.hpp"
#include "reports/summary/results_json.hpp"
#include "sph/threads.hpp"
#include "verification/assessment/campaign_cost.hpp"
#include "verification/assessment/row_kinds.hpp"
#include "verification/campaign/known_drawings.hpp"
#include "verification/cli/campaign/assessed_campaign.hpp"
#include "verification/cli/campaign/earlier_verdicts.hpp"
#include "verification/cli/campaign/report_of_all.hpp"
#include "verification/evidence/soundness.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/sensitivity/case_coverage.hpp"
#include "verification/texts/assessment_text.hpp"
#include "verification/texts/campaign_plan_text.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

// Refuses --resume without an earlier start, so that a mistyped name starts nothing.
void require_possible(const CampaignOptions& options, const CampaignSettings& settings) {
  if (options.resume && !fs::exists(settings.output / "jobs"))
    throw CaseFileError(fmt::format("--resume: expected an earlier start of this campaign in {}",
                                    settings.output.string()));
}

fs::path page_in(const fs::path& place) { return place / "report/index.html"; }

// `campaign` is as a command line names it, and `status` the exit status of the verdict.
void leave_report(const AssessedCampaign& assessed, const CampaignOptions& options,
                  const std::string& campaign, int status) {
  const std::string command =
      fmt::format("./slosh campaign {}{}{}", campaign, selection_options(options.selection),
                  experiments_option(whole(options.experiments)));
  reports::Report report = campaign_report(assessed.definition, options.selection.quick, command,
                                           assessed.cases, assessed.problems);
  if (const int asked = requested_exit(status, options); asked != status)
    report.results_json = with_exit_status(asked, report.results_json);
  KnownDrawings drawings(assessed.output / "drawings");
  reports::write_report(report, assessed.output / "report",
                        {.threads = sph::usable_cores(),
                         .gnuplot = [&](const auto& script, const auto& id, const auto& scratch) {
                           return drawings.draw(script, id, scratch);
                         }});
  drawings.write();
}

// Prints each row and leaves the report.
int judge_campaign(RequestedCampaign campaign, const CampaignOptions& options,
                   const Installation& installation, const std::atomic<bool>& stop) {
  const fs::path place = campaign.place;
  const AssessedCampaign assessed = assess(std::move(campaign), stop);
  std::cerr << complaints(assessed.cases, assessed.problems);
  print_lines(gate_lines(assessed.cases, assessed.problems));
  const int status = exit_status(assessed.cases, assessed.problems);
  leave_report(assessed, options, name_or_path(assessed.definition.file, installation.campaigns),
               status);
  std::vector<std::string> lines{fmt::format("{}: {}{}", headline_word(status),
                                             verdict_sentence(assessed.cases, assessed.problems),
                                             coverage_sentence(assessed.cases))};
  for (const CaseAssessment& one : assessed.cases)
    lines.push_back(doubtful_runs(one.definition, one.runs));
  lines.insert(lines.end(), {kinds_sentence(assessed.cases, assessed.problems),
                             cost_sentence(assessed.cases, assessed.problems),
                             fmt::format("report: {}\n", page_in(place).string())});
  std::erase(lines, "");
  print_lines(fmt::format("{}", fmt::join(lines, "\n")));
  return status;
}

int plan_campaign(const CampaignOptions& options, const Installation& installation) {
  const RequestedCampaign campaign = requested(options, installation);
  require_possible(options, campaign.settings);
  std::cout << plan_text(campaign.cases, campaign.definition.problems, campaign.settings);
  return exit_pass;
}

int run_campaign(const CampaignOptions& options, const Installation& installation,
                 const std::atomic<bool>& stop) {
  if (options.dry_run) return plan_campaign(options, installation);
  return superseding(options, installation, [&](EarlierVerdicts& earlier) {
    RequestedCampaign campaign = requested(options, installation);
    require_possible(options, campaign.settings);
    earlier.begin({"report"});
    const int status = judge_campaign(std::move(campaign), options, installation, stop);
    earlier.end("gate", status);
    return requested_exit(status, options);
  });
}

// Takes the place of the name of one campaign, and of what concerns the runs of one.
void add_all_option(CLI::App& report, CampaignOptions& options) {
  CLI::Option* all = report.add_flag(
      "--all", options.all,
      "One page over all campaigns that have a report in DIR/NAME/report (default of DIR: "
      "build/campaigns): their verdicts, and bias and scatter of each model over all of them");
  report.get_option("name")->required(false);
  for (const char* other : {"name", "--quick", "--only", "--tag"})
    all->excludes(report.get_option(other));
}

void add_start_options(CLI::App& command, CampaignOptions& options) {
  command.add_flag("--dry-run", options.dry_run,
                   "Only print what would be run, what that costs and what is kept");
  command.add_flag("--resume", options.resume, "Continue an earlier start, which must exist");
}

}  // namespace

void add_campaign_command(const CommandTree& tree) {
  const auto judge = [tree](CampaignOptions options, bool solve) {
    tree.stop_on_signals();
    options.solve = solve;
    return run_campaign(options, tree.installation, tree.stop);
  };
  const auto [campaign, campaign_options] = add_command_on_campaign(
      tree,
      {"campaign",
       "Runs a campaign's cases, compares, reports and gates",
       {"./slosh campaign " + std::string(example_run),
        "./slosh campaign verification --only rigid_rotation -o problems",
        "./slosh campaign small_amplitude --dry-run"}},
      [judge](const CampaignOptions& options) { return judge(options, true); });
  add_selection_options(*campaign, campaign_options->selection);
  add_inconclusive_option(*campaign, *campaign_options);
  add_launch_options(*campaign, *campaign_options);
  add_start_options(*campaign, *campaign_options);
  const auto [report, report_options] = add_command_on_campaign(
      tree,
      {"report",
       "Does the same with the existing results; starts no solver",
       {"./slosh report " + std::string(example_run)}},
      [judge, tree](const CampaignOptions& options) {
        if (options.all) return report_of_all(options, tree.installation);
        if (options.campaign.empty())
          throw CaseFileError("name: expected a campaign, or --all for all that have a report");
        return judge(options, false);
      });
  add_selection_options(*report, report_options->selection);
  add_inconclusive_option(*report, *report_options);
  add_all_option(*report, *report_options);
}

}  // namespace slosh
