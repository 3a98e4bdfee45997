// What the gas above the liquid would change for the solvers that know the liquid alone: it lowers
// the first natural frequency (two-layer theory, Lamb, Hydrodynamics, article 231). A wave whose
// frequency is off by the share s is 2 pi s of its amplitude off after each period. And it must
// follow where the liquid leaves the roof.
#pragma once

#include <vector>

#include "verification/assessment/doubts/model_limit.hpp"
#include "verification/case/case_definition.hpp"
#include "verification/evidence/case_runs.hpp"

namespace slosh {

// Returns the change of the first natural frequency, where there is gravity and a run of ours that
// solves or predicts the flow without the gas; and, where SPH's liquid comes to the roof, the time
// in which gas could follow along it.
std::vector<ModelLimit> gas_limits(const CaseDefinition& definition, const CaseRuns& runs);

}  // namespace slosh
