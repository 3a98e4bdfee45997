// A case in words, for reports and explanations.
#pragma once

#include <string>

#include "verification/case/case_definition.hpp"

namespace slosh {

// "surge X = 0.02 m sin(1.48346 rad/s t)", "at rest"
std::string motion_text(const CaseDefinition& definition);

// "0.35 m deep" and what sets its start or place apart, obstacles included
std::string liquid_text(const CaseDefinition& definition);

// "SPH `recommended`, spacing 10 mm", "interFoam, 50 x 50 cells", "published record of ..."
std::string solver_text(const RunDefinition& run);

}  // namespace slosh
