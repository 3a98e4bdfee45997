// Why the job of a run or a problem failed: from what it left in the store, or else from how its
// process ended and what its log says.
#pragma once

#include <filesystem>
#include <string>

#include "verification/engine/job.hpp"
#include "verification/gate/gate.hpp"

namespace slosh {

// The first line of the tool's message in a job's log, or else the last line that it wrote.
std::string first_error_line(const std::filesystem::path& log);

// Of a job that did not succeed. A result that the store could not keep is missing. A run whose
// solver failed has left why in `failure_file` (run_failure.hpp); of any other end it is left there
// now, as far as it can be written.
RunStatus status_without_result(const JobState& state, const std::filesystem::path& failure_file);

// Of a run that nothing is to be computed of: how it failed when it was last tried, or else that
// it is missing, with this message.
RunStatus missing_status(const std::string& message, const std::filesystem::path& failure_file);

}  // namespace slosh
