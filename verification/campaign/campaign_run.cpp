#include "verification/campaign/campaign_run.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "verification/campaign/campaign_plan.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/engine/launcher.hpp"
#include "verification/engine/progress_display.hpp"
#include "verification/engine/slurm_engine.hpp"
#include "verification/files/own_files.hpp"
#include "verification/files/protected_inputs.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/results/result_seals.hpp"
#include "verification/results/timings.hpp"

namespace slosh {
namespace {

// Enters the result under the run's name. Throws ResultError where it cannot be used.
void take_result(const PlannedRun& planned, const CampaignSettings& settings, CaseRuns& runs) {
  protect_input(planned.file);
  RunResult result = read_stored(planned.file, read_result);
  // Another case or run of the same key may have made it.
  result.case_name = planned.definition->name;
  result.run_name = planned.run->name;
  runs.timings[planned.run->name] =
      comparable_costs(read_timings(settings.store.file(planned.key, ".timings.json")));
  runs.status[planned.run->name] = planned.status;
  runs.results[planned.run->name] = std::move(result);
  show_result(planned.file, link_to_result(settings, *planned.definition, *planned.run));
}

bool is_user_program(const RunDefinition& run) {
  return solver_kind(run).answered_with == AnsweredWith::user_program;
}

struct StoredUnder {
  const std::string& key;
  const char* extension;
};

// Says on standard error that a result is another build's, or that it is computed again because the
// stored one is damaged or another build's.
void tell_of_another(const std::string& name, const StoredUnder& place, const RunStatus& status,
                     const CampaignSettings& settings) {
  if (status.state == RunState::finished && !status.message.empty())
    std::cerr << name << " was " << status.message << '\n';
  if (status.state == RunState::missing && settings.solve &&
      settings.store.newest_file(place.key, place.extension))
    std::cerr << status.message << ": it is computed again\n";
}

// Enters the usable results before anything is started; the run of an unusable one is pending.
void take_stock(std::vector<PlannedRun>& plan, const CampaignSettings& settings,
                std::map<const CaseDefinition*, CaseRuns*>& outcome) {
  for (PlannedRun& planned : plan) {
    CaseRuns& runs = *outcome.at(planned.definition);
    if (planned.status.state == RunState::finished) try {
        take_result(planned, settings, runs);
      } catch (const ResultError& error) {
        planned.status = {RunState::missing, error.what()};
      }
    if (planned.status.state == RunState::failed)
      hide_result(link_to_result(settings, *planned.definition, *planned.run));
    tell_of_another(planned.definition->name + "/" + planned.run->name, {planned.key, ".h5"},
                    planned.status, settings);
    runs.status[planned.run->name] = planned.status;
  }
}

// Enters how a run that was started has ended. Throws CaseFileError where the run refused its case.
void take_over(const JobState& state, PlannedRun& planned, const CampaignSettings& settings,
               CaseRuns& runs) {
  if (state.phase == JobPhase::exited && state.status == exit_usage)
    throw CaseFileError(first_error_line(state.job.log_file));
  RunStatus& status = runs.status[planned.run->name];
  if (!has_succeeded(state)) {
    hide_result(link_to_result(settings, *planned.definition, *planned.run));
    status = status_without_result(state, settings.store.file(planned.key, failure_extension));
    return;
  }
  try {
    planned.status = {RunState::finished, ""};
    take_result(planned, settings, runs);
  } catch (const ResultError& error) {
    status = {RunState::missing, error.what()};
  }
}

// A job and its purpose: a run, a problem by its number, or the timing of a run, whose result is
// not used.
struct Pending {
  Job job;
  PlannedRun* run = nullptr;
  std::optional<std::size_t> problem = {};
  bool is_of_user_program = false;
};

// The longest come first, and before them those of which nothing is known, so that no long job is
// left running alone at the end.
bool is_started_before(const Pending& a, const Pending& b) {
  const auto time = [](const Pending& one) {
    return one.job.expected_time > 0 ? one.job.expected_time
                                     : std::numeric_limits<double>::infinity();
  };
  return time(a) > time(b);
}

std::vector<Pending> pending_jobs(std::vector<PlannedRun>& plan,
                                  const std::vector<ProblemDefinition>& problems,
                                  const std::vector<ProblemRun>& standing,
                                  const CampaignSettings& settings) {
  std::vector<Pending> pending;
  for (std::size_t i = 0; i < problems.size(); ++i)
    if (standing[i].status.state == RunState::missing)
      pending.push_back({.job = job_for(problems[i], settings), .problem = i});
  for (PlannedRun& planned : plan)
    if (is_pending(planned))
      pending.push_back({.job = job_for(planned, settings),
                         .run = &planned,
                         .is_of_user_program = is_user_program(*planned.run)});
  std::stable_sort(pending.begin(), pending.end(), is_started_before);
  for (const PlannedRun& planned : plan)
    for (Job& job : timing_jobs(planned, settings))
      pending.push_back(
          {.job = std::move(job), .is_of_user_program = is_user_program(*planned.run)});
  return pending;
}

// Enters the timings that have been made.
void take_timings(const std::vector<PlannedRun>& plan, const CampaignSettings& settings,
                  std::map<const CaseDefinition*, CaseRuns*>& outcome) {
  for (const PlannedRun& planned : plan)
    if (planned.status.state == RunState::finished)
      outcome.at(planned.definition)->timings[planned.run->name] =
          comparable_costs(read_timings(settings.store.file(planned.key, ".timings.json")));
}

void tell_of_problems(const std::vector<ProblemDefinition>& problems,
                      const std::vector<ProblemRun>& standing, const CampaignSettings& settings) {
  for (std::size_t i = 0; i < problems.size(); ++i)
    tell_of_another(problems[i].name, {key_of(problems[i], settings), ".json"}, standing[i].status,
                    settings);
}

// The files of the results that have been read.
std::vector<std::filesystem::path> taken_results(const std::vector<PlannedRun>& plan,
                                                 const std::vector<ProblemDefinition>& problems,
                                                 const std::vector<ProblemRun>& solved,
                                                 const CampaignSettings& settings) {
  std::vector<std::filesystem::path> files;
  for (const PlannedRun& planned : plan)
    if (planned.status.state == RunState::finished) files.push_back(planned.file);
  for (std::size_t i = 0; i < problems.size(); ++i)
    if (solved[i].result) files.push_back(settings.store.file(solved[i].result->key, ".json"));
  return files;
}

std::vector<JobState> run_jobs(const std::vector<Pending>& pending,
                               const CampaignSettings& settings, const std::atomic<bool>& stop) {
  std::vector<Job> jobs;
  for (const Pending& one : pending) jobs.push_back(one.job);
  // The jobs run side by side on the cores, with one thread each.
  setenv("OMP_NUM_THREADS", "1", 0);
  ProgressDisplay display(std::cerr, style_now_of(STDERR_FILENO), settings.at_once);
  std::set<std::string> told{""};
  const auto show = [&](const std::vector<JobState>& now) {
    for (const JobState& state : now)
      if (state.phase == JobPhase::running && !state.progress)
        if (const std::string text = awaited(state.job); told.insert(text).second) {
          display.erase_live_lines();
          std::cerr << text << "\n";
        }
    display.show(now);
  };
  std::vector<JobState> states = launch(jobs,
                                        {.directory = settings.output / "jobs",
                                         .tool = settings.executable,
                                         .engine = settings.engine,
                                         .at_once = settings.at_once},
                                        stop, show);
  if (stop)
    throw InterruptedError("interrupted: what is finished is kept in " +
                           settings.store.root().string());
  return states;
}

}  // namespace

std::unique_ptr<FileLock> lock_output(const std::filesystem::path& output,
                                      const std::atomic<bool>& stop) {
  const std::filesystem::path file = output / "jobs/lock";
  require_own(file);
  return std::make_unique<FileLock>(file,
                                    [&stop, tell = telling_once("works in " + output.string())] {
                                      if (stop)
                                        throw InterruptedError("interrupted: nothing was started");
                                      tell();
                                    });
}

std::unique_ptr<FileLock> free_output(const std::filesystem::path& output) {
  struct InUse {};
  try {
    return std::make_unique<FileLock>(output / "jobs/lock", [] { throw InUse(); });
  } catch (const InUse&) {
    return nullptr;
  }
}

CampaignRuns run_campaign_jobs(const std::vector<CaseDefinition>& cases,
                               const std::vector<ProblemDefinition>& problems,
                               const CampaignSettings& settings, const std::atomic<bool>& stop) {
  if (settings.solve) wait_for_earlier_arrays(settings.output / "jobs", stop);
  if (stop) throw InterruptedError("interrupted: nothing was started");
  CampaignRuns outcome{std::vector<CaseRuns>(cases.size()), {}};
  std::map<const CaseDefinition*, CaseRuns*> runs_of;
  for (std::size_t i = 0; i < cases.size(); ++i) runs_of[&cases[i]] = &outcome.cases[i];
  std::vector<PlannedRun> plan = plan_runs(cases, settings);
  take_stock(plan, settings, runs_of);
  for (const ProblemDefinition& problem : problems)
    outcome.problems.push_back(standing_problem(problem, settings));
  tell_of_problems(problems, outcome.problems, settings);
  if (!settings.solve) return outcome;

  const auto run_and_take = [&](const std::vector<Pending>& pending) {
    const std::vector<JobState> states = run_jobs(pending, settings, stop);
    for (std::size_t i = 0; i < pending.size(); ++i) {
      const Pending& one = pending[i];
      if (one.run) take_over(states[i], *one.run, settings, *runs_of.at(one.run->definition));
      if (one.problem)
        outcome.problems[*one.problem] = ended_problem(states[i], problems[*one.problem], settings);
    }
  };
  std::vector<Pending> pending = pending_jobs(plan, problems, outcome.problems, settings);
  const auto programs = std::stable_partition(
      pending.begin(), pending.end(), [](const Pending& one) { return !one.is_of_user_program; });
  const std::vector<Pending> last(programs, pending.end());
  pending.erase(programs, pending.end());
  run_and_take(pending);
  if (!last.empty()) {
    const ResultSeals seals(taken_results(plan, problems, outcome.problems, settings));
    run_and_take(last);
    seals.require_unchanged();
  }
  take_timings(plan, settings, runs_of);
  return outcome;
}

}  // namespace slosh
