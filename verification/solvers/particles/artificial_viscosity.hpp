// The viscosity that an SPH run's artificial viscosity amounts to.
#pragma once

#include "verification/case/case_definition.hpp"

namespace slosh {

// Returns alpha h c0 / 8 [m2/s] (Monaghan 2005, section 8.5) of a run that sets alpha, and 0 of one
// that does not. h/dp = 1.5 and c0 = 10 V_max stand for the numbers that the run leaves to its
// scheme.
double artificial_viscosity(const CaseDefinition& definition, const SphRun& run);

}  // namespace slosh
