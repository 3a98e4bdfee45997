// What is doubtful about a case whose file is right: settings that run, and whose results may then
// say less than their user expects. Only what can be told before SPH or interFoam runs is told.
#pragma once

#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/evidence/case_runs.hpp"

namespace slosh {

// Returns a sentence for each doubt, which begins with what it is about. `theories` has the results
// of those theories whose range is to be judged.
std::vector<std::string> case_doubts(const CaseDefinition& definition, const CaseRuns& theories);

}  // namespace slosh
