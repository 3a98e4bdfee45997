// Groups the jobs of a list into Slurm job arrays, and writes the arguments of sbatch for them.
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

// Groups jobs of equal needs, which are rounded up to powers of two. The jobs of an array lie
// within 1000 places of each other (below Slurm's usual MaxArraySize). Arrays of jobs that run
// alone come last.
std::vector<SlurmArray> slurm_arrays(const std::vector<Job>& jobs);

// Returns the arguments of sbatch. The array's indices count from its first job; `after` has the
// ids of the arrays that must have ended first.
std::vector<std::string> sbatch_arguments(const SlurmArray& array, const std::string& directory,
                                          const std::vector<std::string>& after);

}  // namespace slosh
