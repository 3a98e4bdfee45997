// What makes a gate row's metric uncertain beside its own interval, after ASME V&V 20.
//   reference       of a record what its publisher states of it, unknown where that is nothing;
//                   of interFoam and any other solver its numerical uncertainty, unknown of a run
//                   on no refinement path; of potential flow what the metric changes by against its
//                   own coarser run; of closed-form theory nothing, inside its range
//   discretisation  of the candidate, against an experiment alone, unknown of a run on no
//                   refinement path: against theory or another method the candidate's
//                   discretisation error is what the row measures
//   statistics      of a flow that small disturbances decide what its repeats spread (beside the
//                   metric's own interval)
//   input           nothing against theory or another method: both sides are told the same tank,
//                   liquid and motion; against an experiment what its inputs are known to
// What an error costs has the interval of its timings alone.
#pragma once

#include <functional>

#include "verification/case/case_definition.hpp"
#include "verification/evidence/case_runs.hpp"
#include "verification/evidence/refinement.hpp"
#include "verification/gate/gate.hpp"
#include "verification/gate/three_way_verdict.hpp"
#include "verification/metrics/comparison.hpp"

namespace slosh {

// Whether the row compares with what was measured of a real tank: a record, or published impacts.
bool rests_on_experiment(const CaseDefinition& definition, const GateRow& row);

// What a row's uncertainty is measured by. The functions throw ComparisonError or ResultError where
// there is nothing to measure.
struct RowMeasures {
  FindComparison comparison = {};  // of the row's candidate and reference
  MeasureRow measure;
  // Against the coarser run that potential flow leaves beside its own (run_case.hpp).
  MeasureRow measure_against_coarser = {};
  // Of a row that rests on an experiment: input_uncertainty().
  std::function<Contribution(const GateRow&)> input = {};
};

UncertaintyContributions row_uncertainty(const CaseDefinition& definition, const CaseRuns& runs,
                                         const GateRow& row, const RowMeasures& measures);

}  // namespace slosh
