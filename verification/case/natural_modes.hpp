// The natural modes that a case is compared on.
#pragma once

#include <vector>

#include "verification/case/case_definition.hpp"

namespace slosh {

// Half waves between the walls of the first `count` modes that linear theory sets swinging, lowest
// first: the odd ones, which the tank's motion excites, and that of the initial wave; of a tank
// that stands the latter alone.
std::vector<int> natural_modes(const CaseDefinition& definition, int count);

}  // namespace slosh
