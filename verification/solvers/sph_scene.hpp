// A case as the SPH solver sees it.
#pragma once

#include "verification/case/case_definition.hpp"

namespace slosh::sph {
struct Scene;
}

namespace slosh {

// Returns the tank, its motion, the liquid and the gauges, with the choices of one run. The caller
// adds what the run records over time: snapshots and states.
sph::Scene sph_scene(const CaseDefinition& definition, const SphRun& sph);

}  // namespace slosh
