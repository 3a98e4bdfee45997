// The subcommand campaign: runs a campaign's cases, compares and judges them, and writes the
// report.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "reports/pages/write_report.hpp"
#include "reports/summary/headline.hpp"
#include "reports/summary/recorded_campaigns.hpp"
#include "reports/summary/report_sections.hpp"
#include "reports/summary/results_json.hpp"
#include "sph/threads.hpp"
#include "verification/assessment/campaign_cost.hpp"
#include "verification/campaign/known_drawings.hpp"
#include "verification/cli/campaign/earlier_verdicts.hpp"
#include "verification/cli/campaign/gate_files.hpp"
#include "verification/cli/campaign/requested_campaign.hpp"
#include "verification/cli/texts/campaign_text.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/files/foreign/legible_text.hpp"
#include "verification/input/case_file_error.hpp"

namespace slosh {
namespace {

// `campaign --report-only --all`: one page over all campaigns whose reports lie in a directory.

namespace fs = std::filesystem;

// The results.json that the campaigns' reports have or should have, in the order of their names.
std::vector<fs::path> results_in(const fs::path& directory) {
  std::vector<fs::path> files;
  if (!fs::is_directory(directory)) return files;
  for (const auto& entry : fs::directory_iterator(directory))
    // But not what another start is writing (reports/pages/write_report.cpp).
    if (const fs::path report = entry.path() / "report";
        fs::exists(report) && !entry.path().filename().string().starts_with("report.writing-"))
      files.push_back(report / "results.json");
  std::sort(files.begin(), files.end());
  return files;
}

int write_report_of_all(const CampaignOptions& options, const Installation& installation,
                        EarlierVerdicts& earlier) {
  const fs::path directory =
      whole(options.output.empty() ? installation.build / "campaigns" : options.output);
  std::vector<RecordedCampaign> campaigns;
  std::vector<std::string> left_out;
  for (const fs::path& file : results_in(directory)) try {
      if (!fs::is_regular_file(file)) throw std::invalid_argument("expected a file");
      campaigns.push_back(recorded_campaign(
          read_input(file), fs::relative(file.parent_path() / "index.html", directory).string()));
    } catch (const std::invalid_argument& error) {
      left_out.push_back(legible_message(file.lexically_relative(directory).string()));
      std::cerr << legible_message(
          fmt::format("{}: {}; `slosh campaign NAME --report-only` writes its report anew\n",
                      file.string(), error.what()));
    }
  if (campaigns.empty() && left_out.empty())
    throw CaseFileError(fmt::format(
        "--all: expected reports of campaigns, NAME/report/results.json, in {}; `slosh campaign "
        "NAME` leaves one",
        directory.string()));
  earlier.begin(written_pages);
  reports::Report report = report_of_campaigns(campaigns, left_out);
  const int status = exit_status(campaigns, left_out), asked = requested_exit(status, options);
  earlier.judged(status);
  if (asked != status) report.results_json = with_exit_status(asked, report.results_json);
  reports::write_report(report, directory / "report", {.threads = sph::usable_cores()});
  print_lines(fmt::format("{}: {}\nreport: {}\n", headline_word(status), report.verdict,
                          (directory / "report/index.html").string()));
  return asked;
}

// Reads DIR/NAME/report/results.json of each campaign, DIR being the options' output or else
// build/campaigns, and leaves DIR/report. Returns the worst of their exit statuses. Throws
// CaseFileError where there is no such file.
int report_of_all(const CampaignOptions& options, const Installation& installation,
                  const std::atomic<bool>& stop) {
  return superseding(options, installation, stop, [&](EarlierVerdicts& earlier) {
    return write_report_of_all(options, installation, earlier);
  });
}

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
                   const Installation& installation, const std::atomic<bool>& stop,
                   EarlierVerdicts& earlier) {
  const fs::path place = campaign.place;
  const AssessedCampaign assessed = assess(std::move(campaign), stop);
  const int status = exit_status(assessed.cases, assessed.problems);
  earlier.judged(status);
  std::cerr << complaints(assessed.cases, assessed.problems);
  print_lines(gate_lines(assessed.cases, assessed.problems));
  leave_report(assessed, options, name_or_path(assessed.definition.file, installation.campaigns),
               status);
  std::vector<std::string> lines{headline_text(assessed, status), rows_text(assessed),
                                 cost_sentence(assessed.cases, assessed.problems),
                                 fmt::format("report: {}", page_in(place).string()),
                                 speed_sentence(assessed.cases)};
  std::erase(lines, "");
  print_lines(fmt::format("{}\n", fmt::join(lines, "\n")));
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
  return superseding(options, installation, stop, [&](EarlierVerdicts& earlier) {
    RequestedCampaign campaign = requested(options, installation);
    require_possible(options, campaign.settings);
    earlier.begin(written_pages);
    const int status = judge_campaign(std::move(campaign), options, installation, stop, earlier),
              asked = requested_exit(status, options);
    earlier.end("gate", status, asked);
    return asked;
  });
}

void add_own_options(CLI::App& command, CampaignOptions& options) {
  command.add_flag("--dry-run", options.dry_run,
                   "Only print what would be run, what that costs and what is kept");
  command.add_flag("--resume", options.resume, "Continue an earlier start, which must exist");
  CLI::Option* report_only =
      command.add_flag("--report-only", options.report_only,
                       "Start no solver: compare, report and gate the results that are there");
  for (const char* other : {"--dry-run", "--resume", "--jobs", "--launcher", "--timings"})
    report_only->excludes(command.get_option(other));
  // Takes the place of the name of one campaign, and of what concerns the runs of one.
  CLI::Option* all = command.add_flag(
      "--all", options.all,
      "One page over all campaigns that have a report in DIR/NAME/report (default of DIR: "
      "build/campaigns): their verdicts, and bias and scatter of each model over all of them");
  all->needs(report_only);
  command.get_option("name")->required(false);
  command.parse_complete_callback([&options] {
    if (options.campaign.empty() && !options.all) throw CLI::RequiredError("name");
  });
  for (const char* other : {"name", "--quick", "--only", "--tag"})
    all->excludes(command.get_option(other));
}

}  // namespace

void add_campaign_command(const CommandTree& tree) {
  const auto [command, options] =
      add_command_on_campaign(tree,
                              {"campaign",
                               "Runs a campaign's cases, compares, reports and gates",
                               {"./slosh campaign " + std::string(example_run),
                                "./slosh campaign verification --only rigid_rotation -o problems",
                                "./slosh campaign small_amplitude --dry-run",
                                "./slosh campaign --report-only " + std::string(example_run)}},
                              [tree](const CampaignOptions& given, const Installation&) {
                                if (given.all)
                                  return report_of_all(given, tree.installation, tree.stop);
                                tree.stop_on_signals();
                                return run_campaign(given, tree.installation, tree.stop);
                              });
  add_start_options(command, options);
  add_own_options(command, options);
}

}  // namespace slosh
