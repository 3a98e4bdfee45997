// When the runs of a case leave their whole fields.
#pragma once

#include <vector>

#include "verification/case/case_definition.hpp"

namespace slosh {

// [s], increasing: the case's snapshot times and the moments of its animation, each once.
std::vector<double> field_times(const CaseDefinition& definition);

}  // namespace slosh
