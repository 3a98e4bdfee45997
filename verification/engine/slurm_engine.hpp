// Jobs on a cluster by Slurm (slurm.schedmd.com): job arrays of jobs of equal needs. The directory
// of the list, the tool, the case files and the results must be visible on the nodes under the same
// paths. Partition, account and the like come from sbatch's own variables (SBATCH_PARTITION, ...).
#pragma once

#include "verification/engine/job_list.hpp"
#include "verification/engine/launcher.hpp"

namespace slosh {

// As launch(), of a list that is written. A job that has left the queue without a word is lost; a
// controller that does not answer is asked again. Writes slurm.json, the ids of its arrays, to the
// settings' directory.
std::vector<JobState> run_by_slurm(const JobList& list, const LaunchSettings& settings,
                                   const std::atomic<bool>& stop, const ObserveJobs& observe);

// Waits until none of the arrays that slurm.json in the directory names is in the queue any more: a
// start whose own process was killed leaves them there. At once where there is no such file.
void wait_for_earlier_arrays(const std::filesystem::path& directory, const std::atomic<bool>& stop);

}  // namespace slosh
