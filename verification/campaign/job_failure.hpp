// What the log of a job says.
#pragma once

#include <filesystem>
#include <string>

namespace slosh {

// Why it failed, in its own words: the first line of the tool's message, or else the last line that
// it wrote.
std::string complaint_in(const std::filesystem::path& log);

}  // namespace slosh
