// The scatter of a metric between runs of the same flow where the flow is sensitive to small
// disturbances (a breaking wave, an impact). From n repeats with disturbed starts and the standard
// deviation s of their metric, it is the half width of the 95 % prediction interval,
//   U = t_(0.975, n-1) s sqrt(1 + 1/n),
// which holds one more such run in 95 % of all cases. Of a metric that is a magnitude, s is at
// least that of the series (spread_of_series()). Runs are repeats of one another where they differ
// in their start and their particle spacing alone.
#pragma once

#include "verification/case/case_definition.hpp"
#include "verification/evidence/case_runs.hpp"
#include "verification/evidence/refinement.hpp"

namespace slosh {

// t_(0.975, n-1) s of n values: the half width in which 95 % of such values lie about a known mean.
// Throws std::invalid_argument for fewer than two.
double half_width_of_95_percent(const std::vector<double>& values);

bool repeat_one_another(const SphRun& one, const SphRun& other);

// Zero where fewer than three repeats have the metric, and for an ensemble (repeats = N), whose
// mean has its own interval.
double repeat_spread(const CaseDefinition& definition, const CaseRuns& runs, const GateRow& row,
                     const MeasureRow& measure, const FindComparison& comparison);

}  // namespace slosh
