// What is doubtful about the results of an external program: whether they are kept though the
// program has changed, and whether it knows its particle spacing.
#pragma once

#include <string>

#include "verification/case/case_definition.hpp"

namespace slosh {

// Returns what runs the program's text where modules that it loads are no part of the run's key: an
// interpreter ("python3"), or a file that begins with #!. Empty where the run declares `inputs`,
// and for the drivers that Slosh ships.
std::string unlisted_script(const ExternalRun& external, const CaseDefinition& definition);

// "run mine: what python3 loads is no part of its key, ...", and that the runs of one method have
// several spacings of which its command has none; empty where nothing is doubtful.
std::string script_doubt(const RunDefinition& run, const CaseDefinition& definition);

}  // namespace slosh
