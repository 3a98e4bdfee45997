// Runs jobs on this machine by ninja (ninja-build.org), with a build file that has one edge a job.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "verification/engine/job_list.hpp"
#include "verification/engine/launch_settings.hpp"

namespace slosh {

// Returns the build file of a list's jobs. Its commands name jobs by number alone, and the tool by
// an environment variable. Ninja counts a job of several cores as one, so jobs of several cores
// have a pool, of which as many run at once as fit `at_once` cores. A job that runs alone waits for
// all others.
std::string ninja_file(const std::vector<Job>& jobs, int at_once);

// Runs the jobs of a written list as launch() does.
std::vector<JobState> run_by_ninja(const JobList& list, const LaunchSettings& settings,
                                   const std::atomic<bool>& stop, const ObserveJobs& observe);

}  // namespace slosh
