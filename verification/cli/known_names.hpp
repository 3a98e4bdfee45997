// The names that there are to be given to commands.
#pragma once

#include <string>
#include <vector>

#include "verification/cli/command_line.hpp"

namespace slosh {

// Sorted; `kind` is one of campaigns, cases, runs (as CASE/RUN), problems and tags. Throws
// CaseFileError where a file cannot be read.
std::vector<std::string> known_names(const std::string& kind, const Installation& installation);

}  // namespace slosh
