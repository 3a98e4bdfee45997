#include "verification/campaign/campaign_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string_view>

#include "verification/campaign/expected_cost.hpp"
#include "verification/case_file/case_file_error.hpp"
#include "verification/runs/progress_display.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/runs/run_key.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

struct PendingRun {
  std::size_t case_index;
  const RunDefinition* run;
};

// Enters the result under the run's name. Throws ResultError where there is none that fits: what a
// solver could compute must be of this very build, what is only read must be of this case and run.
void take_result(const CaseDefinition& definition, const RunDefinition& run,
                 const CampaignSettings& settings, CaseRuns& runs) {
  const fs::path file = result_file(settings, definition, run);
  RunResult result = read_result(file);
  const std::string key =
      run_key(definition, run, settings.solver_build, settings.openfoam_templates);
  runs.status[run.name] = status_of({file, result.key, key}, "state of the case file", settings);
  runs.results[run.name] = std::move(result);
}

Job job_for(const CaseDefinition& definition, const RunDefinition& run,
            const CampaignSettings& settings) {
  const fs::path result = result_file(settings, definition, run);
  fs::path stem = result;
  stem.replace_extension();
  Job job;
  job.name = definition.name + "/" + run.name;
  job.log_file = stem.string() + ".log";
  job.progress_file = stem.string() + ".progress";
  job.command = {settings.executable.string(),
                 "run",
                 definition.file.string(),
                 run.name,
                 "--output",
                 result.string(),
                 "--progress-file",
                 job.progress_file.string()};
  if (!settings.experiments.empty())
    job.command.insert(job.command.end(), {"--experiments", settings.experiments.string()});
  return job;
}

// Enters what stands before anything is started, and returns the runs that are to be computed.
std::vector<PendingRun> take_stock(const std::vector<CaseDefinition>& cases,
                                   const CampaignSettings& settings,
                                   std::vector<CaseRuns>& outcome) {
  std::vector<PendingRun> pending;
  for (std::size_t c = 0; c < cases.size(); ++c)
    for (const RunDefinition& run : cases[c].runs) {
      RunStatus& status = outcome[c].status[run.name];
      if (!is_selected(settings.selection, cases[c], run)) {
        status = {RunState::not_selected, ""};
        continue;
      }
      const auto* record = std::get_if<RecordRun>(&run.solver);
      if (record && !record->supplied) {
        status = {RunState::not_supplied, where_to_get(*record, cases[c])};
        continue;
      }
      try {
        take_result(cases[c], run, settings, outcome[c]);
        if (!status.message.empty())
          std::cerr << cases[c].name << "/" << run.name << " was " << status.message << '\n';
      } catch (const ResultError& error) {
        status = {RunState::missing, error.what()};
        if (!settings.solve) continue;
        pending.push_back({c, &run});
        if (fs::exists(result_file(settings, cases[c], run)))
          std::cerr << error.what() << ": it is computed again\n";
      }
    }
  return pending;
}

// Enters how a run that was started has ended. Throws CaseFileError where the run refused its case.
void take_over(const JobState& state, const CaseDefinition& definition, const RunDefinition& run,
               const CampaignSettings& settings, CaseRuns& runs) {
  if (state.phase == JobPhase::exited && state.status == exit_usage)
    throw CaseFileError(complaint_in(state.job.log_file));
  RunStatus& status = runs.status[run.name];
  if (!has_succeeded(state)) {
    status = {RunState::failed, description(state) + ": " + complaint_in(state.job.log_file)};
    return;
  }
  try {
    take_result(definition, run, settings, runs);
  } catch (const ResultError& error) {
    status = {RunState::missing, error.what()};
  }
}

}  // namespace

RunStatus status_of(const KeptResult& kept, const std::string& asked,
                    const CampaignSettings& settings) {
  constexpr const char* made_by_another_build = "made by another build or version";
  const auto& [file, key, expected] = kept;
  if (!asks_the_same(key, expected))
    throw ResultError(file.string() + " was made for another " + asked);
  if (key == expected) return {RunState::finished, ""};
  if (settings.solve) throw ResultError(file.string() + " was " + made_by_another_build);
  return {RunState::finished, made_by_another_build};
}

std::vector<JobState> run_jobs(const std::vector<Job>& jobs, const std::string& what,
                               const CampaignSettings& settings, const std::atomic<bool>& stop) {
  // They share the cores by running side by side, one thread each.
  setenv("OMP_NUM_THREADS", "1", 0);
  ProgressDisplay display(std::cerr, style_of_standard_error());
  std::vector<JobState> states = run_pool(
      jobs, settings.at_once, stop, [&](const std::vector<JobState>& now) { display.show(now); });
  if (stop)
    throw InterruptedError("interrupted: finished " + what + " are kept in " +
                           settings.output.string());
  return states;
}

std::string complaint_in(const fs::path& log) {
  constexpr std::string_view mark = "slosh: ";  // main.cpp puts it before every error
  std::ifstream stream(log);
  std::string line, last;
  while (std::getline(stream, line)) {
    if (line.starts_with(mark)) return line.substr(mark.size());
    if (!line.empty()) last = line;
  }
  return last;
}

fs::path result_file(const CampaignSettings& settings, const CaseDefinition& definition,
                     const RunDefinition& run) {
  return settings.output / "runs" / definition.name / (run.name + ".h5");
}

std::vector<CaseRuns> run_cases(const std::vector<CaseDefinition>& cases,
                                const CampaignSettings& settings, const std::atomic<bool>& stop) {
  std::vector<CaseRuns> outcome(cases.size());
  std::vector<PendingRun> pending = take_stock(cases, settings, outcome);
  const auto cost = [&](const PendingRun& one) {
    return expected_cost(cases[one.case_index], *one.run);
  };
  std::stable_sort(pending.begin(), pending.end(),
                   [&](const PendingRun& a, const PendingRun& b) { return cost(a) > cost(b); });
  std::vector<Job> jobs;
  for (const PendingRun& one : pending)
    jobs.push_back(job_for(cases[one.case_index], *one.run, settings));

  const std::vector<JobState> states = run_jobs(jobs, "runs", settings, stop);
  for (std::size_t i = 0; i < pending.size(); ++i)
    take_over(states[i], cases[pending[i].case_index], *pending[i].run, settings,
              outcome[pending[i].case_index]);
  return outcome;
}

}  // namespace slosh
