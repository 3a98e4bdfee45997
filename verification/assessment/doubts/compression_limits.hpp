// What is compressed in the experiment and not in the models, or the other way round:
// - Trapped air: a pocket is compressed by about the impact's pressure over its own, that of the
//   atmosphere (Bagnold 1939).
// - The liquid: the density of a weakly compressible one differs by the square of the Mach number,
//   1 % at 0.1 (Monaghan 1994).
#pragma once

#include <vector>

#include "verification/assessment/doubts/model_limit.hpp"
#include "verification/case/case_definition.hpp"
#include "verification/evidence/case_runs.hpp"

namespace slosh {

// Returns, of those that apply:
// - the compression of trapped air by the highest pressure that is known of the impacts: the
//   highest declared one; else the highest that the runs recorded where still liquid does not
//   reach, through the gauge's filter if it has one; else 4 rho V^2 of the expected speed V, where
//   liquid may strike a sensor
// - the compressibility of an SPH run that sets its own speed of sound and has no result, which
// would
//   tell (evidence/soundness.hpp)
std::vector<ModelLimit> compression_limits(const CaseDefinition& definition, const CaseRuns& runs);

}  // namespace slosh
