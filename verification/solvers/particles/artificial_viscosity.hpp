// The viscosity that an SPH run's artificial viscosity amounts to.
#pragma once

#include "verification/case/case_definition.hpp"

namespace slosh {

// Returns the kinematic viscosity [m2/s] of a run that sets alpha, and 0 of one that does not, or
// whose scheme has no alpha: alpha h c0 / 8 where the artificial viscosity acts on all pairs
// (Monaghan 2005, section 8.5). Where it acts on approaching pairs alone, as Monaghan's does, it is
// half of that: of the directions n in a flow that only shears or strains, half approach, and the
// mean of (n . grad v . n)^2 over these is that over all. h and c0 are those of the run or of its
// scheme, V_max is the estimate.
double artificial_viscosity(const CaseDefinition& definition, const SphRun& run);

}  // namespace slosh
