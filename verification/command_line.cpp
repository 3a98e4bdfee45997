#include "verification/command_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <vector>

#include "reports/write_report.hpp"
#include "verification/campaign/campaign_report.hpp"
#include "verification/campaign/campaign_run.hpp"
#include "verification/campaign/problem_run.hpp"
#include "verification/case_file/campaign_parser.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/case_file/problem_table.hpp"
#include "verification/problems/problem.hpp"
#include "verification/runs/cost_meter.hpp"
#include "verification/runs/progress_file.hpp"
#include "verification/runs/provenance.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/runs/run_key.hpp"
#include "verification/runs/snapshots.hpp"
#include "verification/runs/state_file.hpp"

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

// Throws CaseFileError where there is none of that name.
const Problem& named_problem(const std::string& name) try {
  return find_problem(name);
} catch (const std::invalid_argument& error) {
  throw CaseFileError(error.what());
}

// Throws SolverError where the solver fails.
ProblemOutcome outcome_of(const Problem& problem, bool quick) try {
  return problem.run(quick);
} catch (const std::runtime_error& error) {
  throw SolverError(error.what());
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

// How a command line names the file: a shipped one by its name, any other by its path.
std::string name_or_path(const fs::path& file, const fs::path& shipped) {
  if (fs::equivalent(fs::absolute(file).parent_path(), shipped)) return file.stem().string();
  return fmt::format("'{}'", fs::absolute(file).lexically_normal().string());
}

fs::path whole(const fs::path& path) {
  return path.empty() ? path : fs::absolute(path).lexically_normal();
}

// What a command needs to find the user's records again.
std::string experiments_option(const fs::path& experiments) {
  return experiments.empty() ? "" : fmt::format(" --experiments '{}'", experiments.string());
}

std::vector<fs::path> definitions_in(const fs::path& directory) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(directory))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

// The interval at which a run tells how far it is; the parent looks five times a second.
constexpr auto progress_interval = std::chrono::milliseconds(200);

Progress progress_writer(const fs::path& file, double end_time) {
  if (file.empty()) return [](double, double) {};
  return [file, end_time, last = std::chrono::steady_clock::time_point{}](double time,
                                                                          double steps) mutable {
    const auto now = std::chrono::steady_clock::now();
    if (now - last < progress_interval) return;
    last = now;
    write_progress({time, end_time, steps}, file);
  };
}

}  // namespace

int run_campaign(const CampaignOptions& options, const Installation& installation,
                 const std::atomic<bool>& stop) {
  const CampaignDefinition campaign =
      read_campaign(find_campaign(options.campaign, installation.campaigns), installation.cases,
                    known_problems());
  const fs::path experiments = whole(options.experiments);
  const std::vector<CaseDefinition> cases = read_cases(campaign, experiments);
  const std::string form = options.quick ? "-quick" : "";
  const CampaignSettings settings{
      fs::absolute(options.output.empty()
                       ? installation.build / "campaigns" / (campaign.name + form)
                       : options.output),
      installation.executable,
      installation.solver_build,
      installation.problem_build,
      installation.openfoam_templates,
      experiments,
      options.quick,
      options.solve,
      options.at_once};
  std::vector<ProblemRun> problem_runs = run_problems(campaign.problems, settings, stop);
  std::vector<CaseRuns> runs = run_cases(cases, settings, stop);

  std::vector<CaseAssessment> assessed;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    assessed.push_back(assess(cases[i], std::move(runs[i])));
    print(assessed.back());
  }
  std::vector<ProblemAssessment> problems;
  for (std::size_t i = 0; i < campaign.problems.size(); ++i) {
    problems.push_back(assess(campaign.problems[i], std::move(problem_runs[i])));
    print(problems.back());
  }
  const std::string command =
      fmt::format("./slosh campaign {}{}{}", name_or_path(campaign.file, installation.campaigns),
                  options.quick ? " --quick" : "", experiments_option(experiments));
  const fs::path report = settings.output / "report";
  reports::write_report(campaign_report(campaign, options.quick, command, assessed, problems),
                        report);
  const int status = exit_status(assessed, problems);
  std::cout << (status == exit_pass ? "PASS: " : "FAIL: ") << verdict_sentence(assessed, problems)
            << "\nreport: " << (report / "index.html").string() << "\n";
  return status;
}

int run_one(const RunOptions& options, const Installation& installation) {
  const fs::path experiments = whole(options.experiments);
  const CaseDefinition definition =
      read_case(find_case(options.case_name, installation.cases), experiments);
  const auto run = std::find_if(definition.runs.begin(), definition.runs.end(),
                                [&](const RunDefinition& one) { return one.name == options.run; });
  if (run == definition.runs.end()) {
    std::string names;
    for (const RunDefinition& one : definition.runs)
      names += (names.empty() ? "" : ", ") + one.name;
    throw CaseFileError(fmt::format("{}: run = {}: expected one of {}", definition.file.string(),
                                    options.run, names));
  }
  const fs::path file = options.output.empty() ? fs::path(run->name + ".h5") : options.output;
  fs::path work = file;
  work.replace_extension(".work");
  RunSettings settings;
  settings.work_directory = work;
  settings.openfoam_templates = installation.openfoam_templates;
  settings.snapshot_interval = options.snapshot_interval;
  settings.state_interval = options.state_interval;
  settings.resume = options.resume;
  settings.key =
      run_key(definition, *run, installation.solver_build, installation.openfoam_templates);
  settings.command = fmt::format(
      "./slosh run {} {} --output {}.h5{}", name_or_path(definition.file, installation.cases),
      run->name, run->name,
      std::holds_alternative<RecordRun>(run->solver) ? experiments_option(experiments) : "");
  write_result(execute(definition, *run, settings,
                       progress_writer(options.progress_file, definition.duration)),
               file);
  std::cout << "result: " << file.string() << "\n";
  if (options.snapshot_interval != 0)
    std::cout << "snapshots: " << snapshot_index(work, run->name).string() << "\n";
  if (options.state_interval != 0)
    std::cout << "state: " << state_file(work, run->name).string() << "\n";
  return exit_pass;
}

int run_problem(const ProblemOptions& options, const Installation& installation) {
  const Problem& problem = named_problem(options.problem);
  const fs::path file = options.output.empty() ? fs::path(problem.name + ".json") : options.output;
  const CostMeter meter;
  ProblemResult result;
  result.problem = problem.name;
  result.quick = options.quick;
  result.key = problem_key(problem.name, options.quick, installation.problem_build);
  result.provenance = provenance(
      fmt::format("./slosh problem {}{}", problem.name, options.quick ? " --quick" : ""));
  result.outcome = outcome_of(problem, options.quick);
  result.cost = meter.cost();
  write_problem_result(result, file);
  for (const MeasuredErrors& measure : result.outcome.measures) {
    std::cout << measure.name << ":";
    for (const ErrorAtStep& one : measure.errors) std::cout << fmt::format(" {:.3g}", one.error);
    if (const auto order = order_of(measure.errors))
      std::cout << fmt::format(", order {:.2f}", *order);
    std::cout << "\n";
  }
  std::cout << "result: " << file.string() << "\n";
  return exit_pass;
}

int list_definitions(const Installation& installation) {
  std::cout << "campaigns:\n";
  for (const fs::path& file : definitions_in(installation.campaigns)) {
    const CampaignDefinition campaign = read_campaign(file, installation.cases, known_problems());
    std::cout << fmt::format("  {:<36} {}\n", campaign.name, campaign.title);
  }
  std::cout << "cases:\n";
  for (const fs::path& file : definitions_in(installation.cases)) {
    const CaseDefinition definition = read_case(file);
    std::cout << fmt::format("  {:<36} {}", definition.name, definition.title);
    if (!definition.tags.empty())
      std::cout << fmt::format(" [{}]", fmt::join(definition.tags, ", "));
    std::cout << "\n";
    for (const RunDefinition& run : definition.runs) std::cout << "      " << run.name << "\n";
  }
  std::cout << "problems:\n";
  for (const Problem& problem : all_problems())
    std::cout << fmt::format("  {:<36} {}\n", problem.name, problem.title);
  return exit_pass;
}

}  // namespace slosh
