// The largest speed that a case's liquid is expected to reach.
#pragma once

#include "verification/case/case_definition.hpp"

namespace slosh {

// Returns the estimate V [m/s] that the speed of sound of SPH follows (sph/scheme.hpp): sqrt(g h),
// or twice that where a dam breaks, plus the largest speed of the tank.
double expected_speed(const CaseDefinition& definition);

}  // namespace slosh
