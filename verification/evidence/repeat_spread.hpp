// How far a metric of one run may lie from that of another run of the same flow, where small
// disturbances decide what the flow does (a wave that breaks, an impact): from repeats with
// disturbed starts,
//   U = t_(0.975, n-1) s sqrt(1 + 1/n),
// s their standard deviation: the interval that holds one more such run in 95 % of all cases.
// Repeats count that are alike but for their start and the particle spacing.
#pragma once

#include "verification/case/case_definition.hpp"
#include "verification/evidence/case_runs.hpp"
#include "verification/evidence/refinement.hpp"

namespace slosh {

bool repeat_one_another(const SphRun& one, const SphRun& other);

// Zero of fewer than three repeats that have the metric, and of an ensemble (repeats = N), whose
// mean has its own interval.
double repeat_spread(const CaseDefinition& definition, const CaseRuns& runs, const GateRow& row,
                     const MeasureRow& measure);

}  // namespace slosh
