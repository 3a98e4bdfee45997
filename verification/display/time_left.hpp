// An estimate of the time that a campaign still needs: the expected times of its jobs, corrected by
// the times of those that have ended or made enough progress.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/engine/job.hpp"

namespace slosh {

// Returns the wall time [s] on `at_once` cores: the time of the jobs that share the cores, which is
// at least that of the longest of them, and then the time of the jobs that run alone. Returns
// nullopt where the expected time of a job is not known.
std::optional<double> time_left(const std::vector<JobState>& states, int at_once);

// "40 s", "3 min", "2.5 h".
std::string rough_time(double seconds);

// "0:05", "1:02:30".
std::string clock_time(double seconds);

}  // namespace slosh
