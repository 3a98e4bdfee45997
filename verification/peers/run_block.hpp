// The [[run]] table of a case file that takes the output of another code back as an external run.
#pragma once

#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"

namespace slosh {

// Returns the table as TOML with a comment above it. Series of quantities that the case does not
// compare are left out. Throws std::invalid_argument where none is left.
std::string run_block(const std::string& name, const ExternalRun& external,
                      const CaseDefinition& definition, const std::string& comment);

}  // namespace slosh
