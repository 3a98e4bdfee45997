// What the gas above the liquid would change for the solvers that know the liquid alone: it lowers
// the first natural frequency (two-layer theory, Lamb, Hydrodynamics, article 231). A wave whose
// frequency is off by the share s is 2 pi s of its amplitude off after each period.
#pragma once

#include <vector>

#include "verification/assessment/doubts/model_limit.hpp"
#include "verification/case/case_definition.hpp"

namespace slosh {

// Returns the change of the first natural frequency, where there is gravity and a run of ours that
// solves or predicts the flow without the gas.
std::vector<ModelLimit> gas_limits(const CaseDefinition& definition);

}  // namespace slosh
