// Runs jobs on a cluster by Slurm (slurm.schedmd.com), as job arrays of jobs of equal needs. The
// directory of the list, the tool, the case files and the results must be visible on the nodes
// under the same paths. Partition, account and the like come from sbatch's own variables
// (SBATCH_PARTITION, ...).
#pragma once

#include <atomic>
#include <filesystem>
#include <vector>

#include "verification/engine/job_list.hpp"
#include "verification/engine/launch_settings.hpp"

namespace slosh {

// Runs the jobs of a written list as launch() does. A job that has left the queue without a record
// of its end is lost, or not started where it has not begun; a controller that does not answer is
// asked again. The ids of the arrays are written to slurm.json in the settings' directory.
std::vector<JobState> run_by_slurm(const JobList& list, const LaunchSettings& settings,
                                   const std::atomic<bool>& stop, const ObserveJobs& observe);

// Waits until none of the arrays that slurm.json in the directory names is in the queue any more: a
// start whose own process was killed leaves them there. Returns at once where there is no such
// file.
void wait_for_earlier_arrays(const std::filesystem::path& directory, const std::atomic<bool>& stop);

}  // namespace slosh
