#include "verification/cli/campaign/requested_campaign.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <set>
#include <stdexcept>
#include <utility>

#include "reports/model/report_files.hpp"
#include "sph/threads.hpp"
#include "verification/baseline/baseline_ledger.hpp"
#include "verification/campaign/campaign_run.hpp"
#include "verification/case/campaign_definition.hpp"
#include "verification/case/ensemble.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case_file/campaign_parser.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/cli/texts/campaign_text.hpp"
#include "verification/evidence/case_evidence.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/problems/problem_list.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/runs/run_key.hpp"

namespace slosh {
namespace {

// A row whose record is not in the directory that the user named was to be judged.
void miss_records(CaseAssessment& assessment) {
  for (GateOutcome& outcome : assessment.gate)
    if (outcome.verdict == Verdict::not_supplied) outcome.verdict = Verdict::not_compared;
}

namespace fs = std::filesystem;

// What helps where the window is long enough for all modes but the natural ones.
std::string natural_modes_remedy(const CaseDefinition& definition, TimeWindow window) {
  std::vector<ToneRequest> forced = fitted_modes(definition);
  std::erase_if(forced, [](const ToneRequest& one) { return one.refine; });
  try {
    require_resolved(window, forced);
  } catch (const ComparisonError&) {
    return "";
  }
  return "; or natural_modes = 0 in [comparison], which fits no natural mode";
}

// The window, and the rows' own parts of the run, are long enough for the modes.
void require_windows(const CaseDefinition& definition) {
  const auto require = [&](TimeWindow window, const std::string& where) {
    try {
      require_resolved(window, fitted_modes(definition));
    } catch (const ComparisonError& error) {
      throw CaseFileError(where + error.what() + natural_modes_remedy(definition, window));
    }
  };
  require({definition.window_begin, definition.window_end},
          definition.file.string() + ": comparison: ");
  for (const GateRow& row : definition.gate)
    if (row.part && row.metric != Metric::largest_magnitude && has_modes(row.quantity))
      require({row.part->first, row.part->second},
              fmt::format("{}:{}: part_begin_s: ", row.where.file, row.where.line));
}

// Ledgers and documents know a row by its name, which gives its numbers in few digits.
void require_names_apart(const CaseDefinition& definition) {
  std::set<std::string> names;
  for (const GateRow& row : definition.gate)
    if (const std::string name = row_name(row); !names.insert(name).second)
      throw CaseFileError(fmt::format("{}:{}: gate: expected one row of the name '{}'",
                                      row.where.file, row.where.line, name));
}

void require_timed_runs(const CampaignDefinition& campaign,
                        const std::vector<CaseDefinition>& cases) {
  for (const std::string& pattern : campaign.timing.only) {
    const auto names_one_of = [&](const CaseDefinition& one) {
      return std::any_of(one.runs.begin(), one.runs.end(), [&](const RunDefinition& run) {
        return names_run({.only = {pattern}}, one, run);
      });
    };
    if (std::none_of(cases.begin(), cases.end(), names_one_of))
      throw CaseFileError(fmt::format("{}: timing.only = \"{}\": expected patterns of its runs",
                                      campaign.file.string(), pattern));
  }
}

std::vector<CaseDefinition> read_cases(const CampaignDefinition& campaign,
                                       const fs::path& experiments) {
  std::vector<CaseDefinition> cases;
  Complaints complaints;
  for (const fs::path& file : campaign.cases)
    complaints.allow([&] {
      CaseDefinition definition = read_case(file, experiments);
      for (const CaseDefinition& other : cases)
        if (other.name == definition.name)
          throw CaseFileError(
              fmt::format("{}: name = \"{}\": expected a name other than that of {}", file.string(),
                          definition.name, other.file.string()));
      add_swept_runs(campaign, definition);
      cases.push_back(std::move(definition));
    });
  complaints.tell();
  require_swept_cases(campaign, cases);
  require_timed_runs(campaign, cases);
  return cases;
}

std::vector<std::string> names_of(const std::vector<ProblemDefinition>& problems) {
  std::vector<std::string> names;
  for (const ProblemDefinition& one : problems) names.push_back(one.name);
  return names;
}

TimingDefinition timing_of(const CampaignDefinition& campaign, const CampaignOptions& options) {
  TimingDefinition timing = campaign.timing;
  if (options.timings) timing.repeats = *options.timings;
  return timing;
}

fs::path output_of(const CampaignOptions& options, const std::string& name,
                   const Installation& installation) {
  return whole(options.output.empty() ? installation.build / "campaigns" / (name + form_of(options))
                                      : options.output);
}

fs::path place_in(const fs::path& output, const RunSelection& selection) {
  return selection.is_partial() ? output / "selected" : output;
}

CampaignDefinition definition_of(const CampaignOptions& options, const Installation& installation) {
  return read_campaign(find_campaign(options.campaign, installation.campaigns), installation.cases,
                       known_problems());
}

}  // namespace

void add_campaign_options(CLI::App& command, CampaignOptions& options) {
  add_option(command, "name", options.campaign, campaign_type,
             "A campaign of `slosh list`, or the path of a campaign file")
      ->required();
  command.add_flag("--quick", options.selection.quick,
                   "Only the runs that the cases mark as quick");
  add_option(command, "-o,--output", options.output, directory_type,
             "Directory of the results and the report (default: build/campaigns/NAME, with "
             "-quick after the NAME of a quick form)")
      ->check([](const std::string& named) {
        const bool is_other =
            std::filesystem::exists(named) && !std::filesystem::is_directory(named);
        return is_other ? named + ": expected a directory" : std::string();
      });
  add_experiments_option(command, options.experiments);
}

void add_ledger_option(CLI::App& command, CampaignOptions& options) {
  add_option(command, "--ledger", options.ledger, file_type,
             "The baselines' ledger (default: NAME.jsonl, with -quick after the NAME of a quick "
             "form, in verification/baselines or, of a campaign of yours, beside its file)");
}

void add_start_options(CLI::App& command, CampaignOptions& options) {
  add_option(command, "--only", options.selection.only, pattern_type,
             "Only the cases (CASE), runs (CASE/RUN) or problems that this pattern matches, "
             "and what judges them; may be given again. The report goes to selected/")
      ->allow_extra_args(false);
  add_option(command, "--tag", options.selection.tags, tag_type,
             "Only the cases with this tag; may be given again")
      ->allow_extra_args(false);
  add_option(command, "--inconclusive-exit", options.inconclusive_exit, "N",
             "Exit status where rows are inconclusive and nothing is worse (default: 5)")
      ->check(keeps(integer_between(0, largest_exit)));
  add_jobs_option(command, options.at_once, "Runs side by side");
  command
      .add_option_function<std::string>(
          "--launcher",
          [&options](const std::string& name) {
            options.engine = name == "slurm" ? Engine::slurm : Engine::ninja;
          },
          "What runs them: ninja, on this machine (default), or slurm, on a cluster")
      ->check(unnamed(one_of("an engine", {"ninja", "slurm"})))
      ->type_name("ENGINE");
  add_option(command, "--timings", options.timings, "N",
             "Repeats of each run, one at a time, for its timings (default: as the campaign says)")
      ->check(keeps(at_least(0)));
}

AssessedCampaign assess(RequestedCampaign campaign, const std::atomic<bool>& stop) {
  CampaignRuns runs =
      run_campaign_jobs(campaign.cases, campaign.definition.problems, campaign.settings, stop);
  AssessedCampaign assessed{std::move(campaign.definition), campaign.place, {}, {}};
  assessed.cases.resize(campaign.cases.size());
  reports::side_by_side(campaign.cases.size(), sph::usable_cores(), [&](std::size_t i) {
    assessed.cases[i] = assess(campaign.cases[i], std::move(runs.cases[i]));
    if (!campaign.settings.experiments.empty()) miss_records(assessed.cases[i]);
  });
  for (std::size_t i = 0; i < runs.problems.size(); ++i)
    assessed.problems.push_back(
        assess(assessed.definition.problems[i], std::move(runs.problems[i])));
  return assessed;
}

AssessedCampaign assess_present(CampaignOptions options, const Installation& installation) {
  options.report_only = true;
  const std::atomic<bool> never{false};
  return assess(requested(options, installation), never);
}

void print_lines(const std::string& text) {
  std::cout << as_shown(text, style_of(STDOUT_FILENO));
  if (!std::cout.flush()) throw std::runtime_error(not_printed);
}

int requested_exit(int status, const CampaignOptions& options) {
  return status == exit_inconclusive ? options.inconclusive_exit : status;
}

std::string form_of(const CampaignOptions& options) {
  return options.selection.quick ? "-quick" : "";
}

void require_runnable(const std::vector<CaseDefinition>& cases) {
  Complaints complaints;
  for (const CaseDefinition& definition : cases) {
    complaints.allow([&] { require_windows(definition); });
    complaints.allow([&] { require_names_apart(definition); });
    for (const RunDefinition& run : definition.runs)
      complaints.allow([&] { require_runnable(definition, run); });
    for (const GateRow& row : definition.gate)
      complaints.allow([&] { require_series(definition, row); });
  }
  complaints.tell();
}

RequestedCampaign requested(const CampaignOptions& options, const Installation& installation) {
  RequestedCampaign campaign{
      .definition = definition_of(options, installation), .cases = {}, .settings = {}, .place = {}};
  const fs::path experiments = whole(options.experiments);
  campaign.cases = read_cases(campaign.definition, experiments);
  require_matches(options.selection, {campaign.cases, names_of(campaign.definition.problems)});
  require_runnable(campaign.cases);
  if (options.selection.quick)
    for (CaseDefinition& one : campaign.cases) keep_quick_members(one);
  campaign.settings = {.output = output_of(options, campaign.definition.name, installation),
                       .store = ResultStore(whole(options.store.empty() ? usual_store(installation)
                                                                        : options.store)),
                       .campaign_file = whole(campaign.definition.file),
                       .executable = installation.executable,
                       .builds = installation.builds,
                       .openfoam_templates = installation.openfoam_templates,
                       .experiments = experiments,
                       .selection = options.selection,
                       .solve = !options.report_only,
                       .engine = options.engine,
                       .at_once = options.at_once,
                       .timing = timing_of(campaign.definition, options)};
  campaign.place = place_in(campaign.settings.output, options.selection);
  for (const CaseDefinition& one : campaign.cases)
    for (const RunDefinition& run : one.runs)
      if (is_selected(options.selection, one, run)) protect_inputs(one, run);
  if (options.selection.is_partial())
    campaign.definition.title += " (" + selection_text(options.selection) + ")";
  return campaign;
}

fs::path place_of(const CampaignOptions& options, const Installation& installation) {
  const std::string name =
      options.output.empty() ? definition_of(options, installation).name : std::string();
  return place_in(output_of(options, name, installation), options.selection);
}

fs::path baselines_of(const CampaignDefinition& campaign, const Installation& installation) {
  const fs::path directory = whole(campaign.file).parent_path();
  return fs::equivalent(directory, installation.campaigns) ? installation.baselines : directory;
}

fs::path ledger_of(const CampaignOptions& options, const CampaignDefinition& campaign,
                   const Installation& installation) {
  if (!options.ledger)
    return baselines_of(campaign, installation) / (campaign.name + form_of(options) + ".jsonl");
  if (!options.new_ledger && !holds_approvals(*options.ledger))
    throw CaseFileError(
        fmt::format("--ledger: '{}' holds no approval; expected the path of a ledger, or `slosh "
                    "baseline approve --new` to begin one there",
                    options.ledger->string()));
  return *options.ledger;
}

}  // namespace slosh
