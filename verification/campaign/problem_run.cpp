#include "verification/campaign/problem_run.hpp"

#include <algorithm>
#include <iostream>

#include "verification/problems/problem.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

// Throws ResultError where there is none that fits.
ProblemRun finished_run(const ProblemDefinition& problem, const CampaignSettings& settings) {
  const fs::path file = problem_file(settings, problem);
  ProblemResult result = read_problem_result(file);
  const std::string key =
      problem_key(problem.name, settings.selection.quick, settings.problem_build);
  const RunStatus status = status_of({file, result.key, key}, "form of the problem", settings);
  return {status, std::move(result)};
}

Job job_for(const ProblemDefinition& problem, const CampaignSettings& settings) {
  const fs::path result = problem_file(settings, problem);
  fs::path log = result;
  log.replace_extension(".log");
  Job job;
  job.name = problem.name;
  job.log_file = log;
  job.command = {settings.executable.string(), "problem", problem.name, "--output",
                 result.string()};
  if (settings.selection.quick) job.command.push_back("--quick");
  return job;
}

ProblemRun ended_run(const JobState& state, const ProblemDefinition& problem,
                     const CampaignSettings& settings) {
  if (!has_succeeded(state))
    return {{RunState::failed, description(state) + ": " + complaint_in(state.job.log_file)}, {}};
  try {
    return finished_run(problem, settings);
  } catch (const ResultError& error) {
    return {{RunState::missing, error.what()}, {}};
  }
}

}  // namespace

fs::path problem_file(const CampaignSettings& settings, const ProblemDefinition& problem) {
  return settings.output / "problems" / (problem.name + ".json");
}

std::vector<ProblemRun> run_problems(const std::vector<ProblemDefinition>& problems,
                                     const CampaignSettings& settings,
                                     const std::atomic<bool>& stop) {
  std::vector<ProblemRun> runs;
  std::vector<std::size_t> pending;
  for (const ProblemDefinition& problem : problems) try {
      if (!names_problem(settings.selection, problem.name)) {
        runs.push_back({{RunState::not_selected, ""}, {}});
        continue;
      }
      runs.push_back(finished_run(problem, settings));
      if (!runs.back().status.message.empty())
        std::cerr << problem.name << " was " << runs.back().status.message << '\n';
    } catch (const ResultError& error) {
      if (fs::exists(problem_file(settings, problem)) && settings.solve)
        std::cerr << error.what() << ": it is computed again\n";
      pending.push_back(runs.size());
      runs.push_back({{RunState::missing, error.what()}, {}});
    }
  if (!settings.solve || pending.empty()) return runs;
  const auto expected_time = [&](std::size_t i) {
    return find_problem(problems[i].name).expected_time;
  };
  std::stable_sort(pending.begin(), pending.end(), [&](std::size_t a, std::size_t b) {
    return expected_time(a) > expected_time(b);
  });
  std::vector<Job> jobs;
  for (const std::size_t i : pending) jobs.push_back(job_for(problems[i], settings));

  const std::vector<JobState> states = run_jobs(jobs, "problems", settings, stop);
  for (std::size_t i = 0; i < pending.size(); ++i)
    runs[pending[i]] = ended_run(states[i], problems[pending[i]], settings);
  return runs;
}

}  // namespace slosh
