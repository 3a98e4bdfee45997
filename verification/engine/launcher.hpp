// Runs all jobs of a list through an engine of the machine's: ninja here, Slurm on a cluster.
#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include "verification/engine/job.hpp"

namespace slosh {

enum class Engine { ninja, slurm };

struct LaunchSettings {
  // One start at a time works there (whoever calls sees to that); made if need be. Lists of earlier
  // starts are removed from it: what is left of such a start writes into its own list.
  std::filesystem::path directory;
  std::filesystem::path tool;  // whose `job N`, in the directory, runs job N of the list
  Engine engine = Engine::ninja;
  int at_once = 1;  // cores to fill on this machine; a cluster fills its own
};

// The engine cannot be used: what() says why.
struct EngineError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Runs all jobs and returns their last states in the order of the jobs. A crash, a divergence or a
// time-out of one is recorded and leaves the others alone. Once `stop` is true all are ended, their
// own children included, and no further one starts. Throws std::invalid_argument for no core,
// EngineError, and what JobList::create() throws. No string of a job reaches a shell.
std::vector<JobState> launch(const std::vector<Job>& jobs, const LaunchSettings& settings,
                             const std::atomic<bool>& stop, const ObserveJobs& observe);

}  // namespace slosh
