// What is doubtful about the results of an external program: whether they are kept though the
// program has changed, and whether it knows its particle spacing.
#pragma once

#include <string>

#include "verification/case/case_definition.hpp"

namespace slosh {

// Returns what a run may read though it is no part of the run's key. Without `inputs` that is an
// interpreter ("python3") or a file that begins with #!, which load modules. It is also a directory
// that the program starts in or is given, where no input lies in it. Empty where there is none, and
// for the drivers that Slosh ships.
std::string unlisted_script(const ExternalRun& external, const CaseDefinition& definition);

// "run mine: what python3 loads is no part of its key, ...", and that the runs of one method have
// several spacings of which its command has none; empty where nothing is doubtful.
std::string script_doubt(const RunDefinition& run, const CaseDefinition& definition);

}  // namespace slosh
