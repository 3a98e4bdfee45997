// What is doubtful about the results of an external program: whether they are kept though what it
// reads has changed.
#pragma once

#include <string>

#include "verification/case/case_definition.hpp"

namespace slosh {

// Returns what a run may read though it is no part of the run's key. Without `inputs` that is an
// interpreter ("python3") or a file that begins with #!, which load modules. It is also a directory
// that the program starts in or is given, where no input lies in it; a file that an argument names
// without its suffix; and a file that the text of a script or of an input names, where that is no
// input. Empty where there is none, and for the drivers that
// Slosh ships.
std::string unlisted_script(const ExternalRun& external, const CaseDefinition& definition);

// "run mine: what python3 loads is no part of its key, ..."; empty where nothing is doubtful.
std::string script_doubt(const RunDefinition& run, const CaseDefinition& definition);

}  // namespace slosh
