// The times at which the runs of a case write their fields.
#pragma once

#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"

namespace slosh {

// Returns the times [s] of the case's snapshots and of its animation, increasing, each once.
std::vector<double> field_times(const CaseDefinition& definition);

// The quantity of gate rows on pressure fields. No run has a series of this name.
inline constexpr const char* pressure_field = "pressure_field";

// Returns the modes of such rows that are of one moment: "moment_1", "moment_2", ..., in the order
// of the case's snapshot times.
std::vector<std::string> moment_names(const CaseDefinition& definition);

}  // namespace slosh
