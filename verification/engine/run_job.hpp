// Runs one job of a list: an engine starts a process for each job, which calls this.
#pragma once

#include <atomic>

#include "verification/engine/job_list.hpp"

namespace slosh {

// Starts the job, waits for it, enforces its time limit, records in the list how it has ended, and
// returns that. Once `stop` is true the job's process group gets SIGTERM, three seconds later
// what is left of it SIGKILL. Throws std::filesystem::filesystem_error where the list cannot be
// written.
JobState run_job(const JobList& list, std::size_t index, const std::atomic<bool>& stop);

}  // namespace slosh
