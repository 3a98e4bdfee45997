#include "verification/campaign/problem_run.hpp"

#include <utility>

#include "verification/campaign/campaign_plan.hpp"
#include "verification/campaign/job_failure.hpp"
#include "verification/problems/problem_list.hpp"

namespace slosh {

std::string key_of(const ProblemDefinition& problem, const CampaignSettings& settings) {
  return problem_key(find_problem(problem.name), settings.selection.quick, settings.builds);
}

ProblemRun standing_problem(const ProblemDefinition& problem, const CampaignSettings& settings) {
  if (!names_problem(settings.selection, problem.name)) return {{RunState::not_selected, ""}, {}};
  const StandingResult standing = standing_result(key_of(problem, settings), ".json", settings);
  if (standing.status.state != RunState::finished) return {standing.status, {}};
  try {
    ProblemResult result = read_stored(standing.file, read_problem_result);
    show_result(standing.file, settings.output / "problems" / (problem.name + ".json"));
    return {standing.status, std::move(result)};
  } catch (const ResultError& error) {
    return {{RunState::missing, error.what()}, {}};
  }
}

Job job_for(const ProblemDefinition& problem, const CampaignSettings& settings) {
  Job job;
  job.name = problem.name;
  job.log_file = settings.output / "problems" / (problem.name + ".log");
  job.command = {settings.executable.string(), "problem", problem.name, "--store",
                 settings.store.root().string()};
  if (settings.selection.quick) job.command.push_back("--quick");
  job.expected_time = find_problem(problem.name).expected_time;
  job.time_limit =
      time_limit({.processor_time = job.expected_time, .wall_time = job.expected_time});
  return job;
}

ProblemRun ended_problem(const JobState& state, const ProblemDefinition& problem,
                         const CampaignSettings& settings) {
  if (!has_succeeded(state))
    return {status_without_result(
                state, settings.store.file(key_of(problem, settings), failure_extension)),
            {}};
  return standing_problem(problem, settings);
}

}  // namespace slosh
