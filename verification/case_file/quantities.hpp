// What the runs of a case are compared on: the series that every one of them may have.
#pragma once

#include <string>
#include <vector>

#include "verification/case_file/case_definition.hpp"

namespace slosh {

// "front_position" of a breaking dam, then "elevation@<gauge>" of each gauge; all in m. The first
// is the one that the case is about.
std::vector<std::string> compared_quantities(const CaseDefinition& definition);

// The unit of all of them.
inline constexpr const char* compared_unit = "m";

// Whether a quantity swings about a mean, so that modes can be fitted to it; a front runs away.
bool has_modes(const std::string& quantity);

}  // namespace slosh
