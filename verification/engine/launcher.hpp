// Runs all jobs of a list by an engine: ninja on this machine, Slurm on a cluster.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "verification/engine/job.hpp"
#include "verification/engine/job_list.hpp"

namespace slosh {

// Runs jobs on this machine by ninja (ninja-build.org), with a build file that has one edge a job.

// Returns the build file of a list's jobs. Its commands name jobs by number alone, and the tool by
// an environment variable. Ninja counts a job of several cores as one, so jobs of several cores
// have a pool, of which as many run at once as fit `at_once` cores. A job that runs alone waits for
// all others.
std::string ninja_file(const std::vector<Job>& jobs, int at_once);

// Runs the jobs of a written list as launch() does.
std::vector<JobState> run_by_ninja(const JobList& list, const LaunchSettings& settings,
                                   const std::atomic<bool>& stop, const ObserveJobs& observe);

// Runs all jobs and returns their last states in the order of the jobs. A crash, a divergence or a
// time-out of one is recorded and does not affect the others. Once `stop` is true all are ended,
// their own children included, and no further one starts. Throws std::invalid_argument where
// at_once is below 1, EngineError, and what JobList::create() throws. No string of a job reaches a
// shell.
std::vector<JobState> launch(const std::vector<Job>& jobs, const LaunchSettings& settings,
                             const std::atomic<bool>& stop, const ObserveJobs& observe);

}  // namespace slosh
