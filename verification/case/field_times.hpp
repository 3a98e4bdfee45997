// The times at which the runs of a case write their fields.
#pragma once

#include <vector>

#include "verification/case/case_definition.hpp"

namespace slosh {

// Returns the times [s] of the case's snapshots and of its animation, increasing, each once.
std::vector<double> field_times(const CaseDefinition& definition);

}  // namespace slosh
