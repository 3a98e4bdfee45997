// Finds why the job of a run or a problem failed: from the failure file in the store, or else from
// the end of its process and its log; and what it waits for, from its log.
#pragma once

#include <filesystem>
#include <string>

#include "verification/engine/job.hpp"
#include "verification/gate/gate.hpp"

namespace slosh {

// Returns the failure with texts that can be shown: a program's words command no terminal and break
// no document.
RunFailure legible(const RunFailure& failure);

// Returns the first line of the tool's message in a job's log, or else the log's last line.
std::string first_error_line(const std::filesystem::path& log);

// Returns what the job says that it waits for (file_lock.hpp); "" where it does not.
std::string awaited(const Job& job);

// Returns the status of a job that did not succeed. The result of a job that never started, or
// whose result could not be stored, is missing. A run whose solver failed has written the reason to
// `failure_file` (run_failure.hpp); for any other end the reason is written there now, if possible.
RunStatus status_without_result(const JobState& state, const std::filesystem::path& failure_file);

}  // namespace slosh
