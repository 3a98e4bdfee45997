// How long a campaign still takes: what its jobs are expected to take, corrected by what those that
// have ended or are far enough took.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/engine/job.hpp"

namespace slosh {

// [s] of wall time where `at_once` cores work: the rest of the jobs that share the cores, but no
// less than the longest of them alone, and after them those that run alone. Nothing where nothing
// is known of a job.
std::optional<double> time_left(const std::vector<JobState>& states, int at_once);

// "40 s", "3 min", "2.5 h".
std::string rough_time(double seconds);

// "0:05", "1:02:30".
std::string clock_time(double seconds);

}  // namespace slosh
