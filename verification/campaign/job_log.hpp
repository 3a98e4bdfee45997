// What the log of a job says.
#pragma once

#include <filesystem>
#include <string>

#include "verification/engine/job.hpp"
#include "verification/gate/gate.hpp"

namespace slosh {

// Why it failed, in its own words: the first line of the tool's message, or else the last line that
// it wrote.
std::string complaint_in(const std::filesystem::path& log);

// Of a job that did not succeed: whether the solver failed, or its result is missing because it
// could not be kept (a store that is full or read-only), and why.
RunStatus status_without_result(const JobState& state);

}  // namespace slosh
