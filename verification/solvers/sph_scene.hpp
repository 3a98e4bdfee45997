// A case as the SPH solver sees it: the tank, its motion, the liquid and the gauges, with the
// choices of one run. What the run records over time (snapshots, states) is left to the caller.
#pragma once

#include "sph/simulation.hpp"
#include "verification/case/case_definition.hpp"

namespace slosh {

sph::Scene sph_scene(const CaseDefinition& definition, const SphRun& sph);

}  // namespace slosh
