// The name of everything that determines a run's numbers: equal keys, equal results, so that a
// result whose key fits need not be computed again.
#pragma once

#include <filesystem>
#include <string>

#include "verification/case_file/case_definition.hpp"

namespace slosh {

// Hashes the physical part of the case (not its names, comparison and gate), the run's solver and
// its settings (not its name, nor the range in which a reference may gate), the executable's
// content and, for interFoam, its version and the templates' content. Throws
// std::filesystem::filesystem_error where the executable or the templates cannot be read.
std::string run_key(const CaseDefinition& definition, const RunDefinition& run,
                    const std::filesystem::path& executable,
                    const std::filesystem::path& openfoam_templates);

}  // namespace slosh
