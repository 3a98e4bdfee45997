#include "verification/campaign/campaign_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <optional>

#include "verification/runs/progress_display.hpp"
#include "verification/runs/run_key.hpp"
#include "verification/runs/run_pool.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

struct PendingRun {
  std::size_t case_index;
  std::string run;
  double expected_cost;
  Job job;
};

// Orders the queue, longest first, so that no long run is left alone at the end. Core-seconds per
// simulated second as measured on two-core machines; only their order of size matters.
double expected_cost(const CaseDefinition& definition, const RunDefinition& run) {
  const double area = definition.tank.length * definition.liquid.fill_depth;
  if (const auto* sph = std::get_if<SphRun>(&run.solver))
    return definition.duration * 2e-6 * area / std::pow(sph->particle_spacing, 3);
  if (const auto* mesh = std::get_if<InterFoamRun>(&run.solver))
    return definition.duration * 5e-4 * mesh->cells_x * mesh->cells_z;
  return 0;
}

// The result under the run's name, if it is whole and made by what the case declares today.
std::optional<RunResult> kept_result(const fs::path& file, const std::string& key) {
  if (!fs::exists(file)) return std::nullopt;
  try {
    RunResult result = read_result(file);
    if (result.key == key) return result;
  } catch (const ResultError& error) {
    std::cerr << error.what() << ": it is computed again\n";
  }
  return std::nullopt;
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
  return job;
}

// What the run said last, for the report.
std::string last_line(const fs::path& log) {
  std::ifstream stream(log);
  std::string line, last;
  while (std::getline(stream, line))
    if (!line.empty()) last = line;
  return last;
}

RunStatus read_finished(const fs::path& file, CaseRuns& runs, const std::string& run) {
  try {
    runs.results[run] = read_result(file);
    return {RunState::finished, ""};
  } catch (const ResultError& error) {
    return {RunState::failed, error.what()};
  }
}

}  // namespace

fs::path result_file(const CampaignSettings& settings, const CaseDefinition& definition,
                     const RunDefinition& run) {
  return settings.output / "runs" / definition.name / (run.name + ".h5");
}

std::string repeat_command(const CaseDefinition& definition, const RunDefinition& run) {
  return fmt::format("./slosh run {} {} --output {}.h5", definition.name, run.name, run.name);
}

std::vector<CaseRuns> run_cases(const std::vector<CaseDefinition>& cases,
                                const CampaignSettings& settings, const std::atomic<bool>& stop) {
  std::vector<CaseRuns> outcome(cases.size());
  std::vector<PendingRun> pending;
  for (std::size_t c = 0; c < cases.size(); ++c)
    for (const RunDefinition& run : cases[c].runs) {
      CaseRuns& runs = outcome[c];
      const fs::path file = result_file(settings, cases[c], run);
      if (settings.quick && !run.quick) {
        runs.status[run.name] = {RunState::not_selected, ""};
      } else if (!settings.solve) {
        runs.status[run.name] = read_finished(file, runs, run.name);
      } else if (auto kept = kept_result(file, run_key(cases[c], run, settings.executable,
                                                       settings.openfoam_templates))) {
        runs.status[run.name] = {RunState::finished, ""};
        runs.results[run.name] = std::move(*kept);
      } else {
        pending.push_back(
            {c, run.name, expected_cost(cases[c], run), job_for(cases[c], run, settings)});
      }
    }
  std::stable_sort(pending.begin(), pending.end(), [](const PendingRun& a, const PendingRun& b) {
    return a.expected_cost > b.expected_cost;
  });

  std::vector<Job> jobs;
  for (const PendingRun& one : pending) jobs.push_back(one.job);
  // Runs share the cores by running side by side, one thread each.
  setenv("OMP_NUM_THREADS", "1", 0);
  ProgressDisplay display(std::cerr, style_of_standard_error());
  const auto states = run_pool(jobs, settings.at_once, stop,
                               [&](const std::vector<JobState>& now) { display.show(now); });
  if (stop)
    throw InterruptedError("interrupted: finished runs are kept in " + settings.output.string());

  for (std::size_t i = 0; i < pending.size(); ++i) {
    CaseRuns& runs = outcome[pending[i].case_index];
    const std::string& name = pending[i].run;
    const CaseDefinition& definition = cases[pending[i].case_index];
    runs.status[name] =
        has_succeeded(states[i])
            ? read_finished(result_file(settings, definition, run_named(definition, name)), runs,
                            name)
            : RunStatus{RunState::failed,
                        description(states[i]) + ": " + last_line(states[i].job.log_file)};
  }
  return outcome;
}

}  // namespace slosh
