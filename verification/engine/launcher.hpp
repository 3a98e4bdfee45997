// Runs all jobs of a list by an engine: ninja on this machine, Slurm on a cluster.
#pragma once

#include <atomic>
#include <vector>

#include "verification/engine/job.hpp"
#include "verification/engine/launch_settings.hpp"

namespace slosh {

// Runs all jobs and returns their last states in the order of the jobs. A crash, a divergence or a
// time-out of one is recorded and does not affect the others. Once `stop` is true all are ended,
// their own children included, and no further one starts. Throws std::invalid_argument where
// at_once is below 1, EngineError, and what JobList::create() throws. No string of a job reaches a
// shell.
std::vector<JobState> launch(const std::vector<Job>& jobs, const LaunchSettings& settings,
                             const std::atomic<bool>& stop, const ObserveJobs& observe);

}  // namespace slosh
