#include "verification/engine/launcher.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "verification/engine/job_list.hpp"
#include "verification/engine/ninja_engine.hpp"
#include "verification/engine/slurm_engine.hpp"

namespace slosh {

std::vector<JobState> launch(const std::vector<Job>& jobs, const LaunchSettings& settings,
                             const std::atomic<bool>& stop, const ObserveJobs& observe) {
  if (settings.at_once < 1)
    throw std::invalid_argument(
        fmt::format("at_once = {}: expected at least one core to fill", settings.at_once));
  if (jobs.empty()) return {};
  const JobList list = JobList::create(settings.directory, jobs);
  return settings.engine == Engine::slurm ? run_by_slurm(list, settings, stop, observe)
                                          : run_by_ninja(list, settings, stop, observe);
}

}  // namespace slosh
