// What makes a gate row's metric uncertain beside its own interval, after ASME V&V 20.
//   reference       of a record what its publisher states of it; of interFoam its numerical
//                   uncertainty; of potential flow what the metric changes by against its own
//                   coarser run; of closed-form theory nothing, inside its range
//   discretisation  of the candidate, against a record alone: against theory or another method the
//                   candidate's discretisation error is what the row measures
//   statistics      of a flow that small disturbances decide what its repeats spread (beside the
//                   metric's own interval)
//   input           nothing: both sides are told the same tank, liquid and motion, and what an
//                   experiment knows of its own is part of its stated uncertainty
// What an error costs has the interval of its timings alone.
#pragma once

#include "verification/campaign/case_runs.hpp"
#include "verification/campaign/refinement.hpp"
#include "verification/case_file/case_definition.hpp"
#include "verification/gate/gate.hpp"
#include "verification/gate/three_way_verdict.hpp"
#include "verification/metrics/comparison.hpp"

namespace slosh {

// The half width of a metric's interval that values uncertain by `half_width` [the series' unit]
// give it, where all are too high or scaled together, relative to the reference's amplitude. Zero
// of metrics that do not depend on the values' size, and of residuals: what scatters the reference
// only raises them.
double uncertainty_from_values(Metric metric, const std::string& mode, const Comparison& comparison,
                               double half_width);

// `comparison` gives that of the row's candidate and reference.
UncertaintyContributions row_uncertainty(const CaseDefinition& definition, const CaseRuns& runs,
                                         const GateRow& row, const FindComparison& comparison,
                                         const MeasureRow& measure);

}  // namespace slosh
