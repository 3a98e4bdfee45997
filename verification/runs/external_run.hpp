// What of a user's own program decides a run's numbers.
#pragma once

#include <filesystem>

#include "verification/case_file/case_definition.hpp"

namespace slosh {

// The program's file; empty where there is none, be it relative to the case file or on the PATH.
std::filesystem::path external_program(const ExternalRun& external,
                                       const CaseDefinition& definition);

}  // namespace slosh
