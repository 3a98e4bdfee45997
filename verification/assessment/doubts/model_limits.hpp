// All effects that the models of a case leave out, and what its motion leaves open.
#pragma once

#include <vector>

#include "verification/assessment/doubts/model_limit.hpp"
#include "verification/case/case_definition.hpp"
#include "verification/evidence/case_runs.hpp"

namespace slosh {

// Returns the effects that the runs of the case leave out, of those that apply: damping
// (damping_limits.hpp), the gap walls (gap_limits.hpp), the gas (gas_limits.hpp),
// surface tension (surface_tension_limits.hpp), compression (compression_limits.hpp) and the noise
// of a motion by a table (motion_noise.hpp). They follow from the case file; where `runs` has
// results, these tell the pressures of impacts and the Mach numbers.
std::vector<ModelLimit> model_limits(const CaseDefinition& definition, const CaseRuns& runs = {});

}  // namespace slosh
