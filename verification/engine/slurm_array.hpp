// Which jobs of a list go to Slurm as one array, and what sbatch is asked for them.
#pragma once

#include <string>
#include <vector>

#include "verification/engine/job.hpp"

namespace slosh {

struct SlurmArray {
  std::vector<std::size_t> jobs;  // of the list, increasing
  int cores;
  int memory;   // [MiB] a job
  int minutes;  // of wall time a job
  bool alone;
};

// Jobs of the same needs, these rounded up to powers of two, that lie within 1000 places of each
// other (below Slurm's usual MaxArraySize); those that want to be alone last.
std::vector<SlurmArray> slurm_arrays(const std::vector<Job>& jobs);

// sbatch's arguments: the array's indices count from its first job. `after`: ids of arrays that
// must have ended first; empty for none.
std::vector<std::string> sbatch_arguments(const SlurmArray& array, const std::string& directory,
                                          const std::vector<std::string>& after);

}  // namespace slosh
