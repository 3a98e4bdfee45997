// The command line of a user's own program, as a case gives it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"

namespace slosh {

// The program's file; empty where there is none, be it relative to the case file or on the PATH.
std::filesystem::path external_program(const ExternalRun& external,
                                       const CaseDefinition& definition);

// Program and arguments, the placeholders filled in. Throws std::invalid_argument for a name in
// braces that is no placeholder.
std::vector<std::string> external_command(const ExternalRun& external,
                                          const CaseDefinition& definition,
                                          const std::filesystem::path& work_directory);

// The files whose content counts as part of the run: the inputs that the case declares, and each
// argument, or what stands behind an argument's "=", that names an existing file relative to the
// case file or to the run's directory. Each file is named once. The case file itself is none of
// them: of it only what the physics needs counts (run_key.hpp). Throws as external_command().
std::vector<std::filesystem::path> external_inputs(const ExternalRun& external,
                                                   const CaseDefinition& definition);

}  // namespace slosh
