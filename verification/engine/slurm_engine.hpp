// Runs jobs on a cluster by Slurm (slurm.schedmd.com), as job arrays of jobs of equal needs. The
// directory of the list, the tool, the case files and the results must be visible on the nodes
// under the same paths. Partition, account and the like come from sbatch's own variables
// (SBATCH_PARTITION, ...).
#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include "verification/engine/job.hpp"
#include "verification/engine/job_list.hpp"

namespace slosh {

// Groups the jobs of a list into Slurm job arrays, and writes the arguments of sbatch for them.

struct SlurmArray {
  std::vector<std::size_t> jobs;  // of the list, increasing
  int cores;
  int memory;   // [MiB] a job
  int minutes;  // of wall time a job
  bool alone;
};

// Groups jobs of equal needs, which are rounded up to powers of two. The jobs of an array lie
// within 1000 places of each other (below Slurm's usual MaxArraySize). Arrays of jobs that run
// alone come last.
std::vector<SlurmArray> slurm_arrays(const std::vector<Job>& jobs);

// Returns the arguments of sbatch. The array's indices count from its first job; `after` has the
// ids of the arrays that must have ended first.
std::vector<std::string> sbatch_arguments(const SlurmArray& array, const std::string& directory,
                                          const std::vector<std::string>& after);

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
