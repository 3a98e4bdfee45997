// Jobs on this machine by ninja (ninja-build.org): a build file of one edge a job.
#pragma once

#include <string>

#include "verification/engine/job_list.hpp"
#include "verification/engine/launcher.hpp"

namespace slosh {

// Of a list's jobs. Commands name jobs by number alone, and the tool by a variable of the
// environment. A job of several cores counts as one for ninja, so that as many of those run at once
// as fit `at_once` cores; one that wants to be alone waits for all others.
std::string ninja_file(const std::vector<Job>& jobs, int at_once);

// As launch(), of a list that is written.
std::vector<JobState> run_by_ninja(const JobList& list, const LaunchSettings& settings,
                                   const std::atomic<bool>& stop, const ObserveJobs& observe);

}  // namespace slosh
