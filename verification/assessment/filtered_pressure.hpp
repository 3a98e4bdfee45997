// The case's filter on the wall pressures of its runs: "wall_pressure@B/filtered" beside
// "wall_pressure@B", of solvers and records alike.
#pragma once

#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"

namespace slosh {

// Adds the filtered series wherever a gauge names a cutoff and a run left its pressure. Returns
// what could not be filtered, "RUN: why".
std::vector<std::string> add_filtered_pressures(const CaseDefinition& definition, CaseRuns& runs);

}  // namespace slosh
