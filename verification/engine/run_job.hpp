// Runs one job of a list in this process's stead: what an engine starts for each of them.
#pragma once

#include <atomic>

#include "verification/engine/job_list.hpp"

namespace slosh {

// Starts the job, waits for it, keeps its time limit, and leaves in the list how it has ended,
// which it returns. Once `stop` is true the job's process group gets SIGTERM, three seconds later
// what is left of it SIGKILL. Throws std::filesystem::filesystem_error where the list cannot be
// written.
JobState run_job(const JobList& list, std::size_t index, const std::atomic<bool>& stop);

}  // namespace slosh
