// The input uncertainty of a gate row that compares with an experiment (ASME V&V 20-2009, section
// 4), by central differences of the metric's prediction,
//   u_input^2 = sum over inputs of ((m(x + u) - m(x - u)) / 2)^2
// u is the half width that the case declares for the input x, and m is the row's metric, measured
// with a prediction for the tank with that input in the place of the candidate. The prediction
// comes from the case's first theory of the liquid alone that is inside its range, otherwise from
// the input's coarse run, repeated at both bounds. The difference of two coarse runs includes their
// scatter: where the flow is chaotic it is too large rather than too small. Without either, the
// row's u_input is unknown. Against theory or another method both sides have the same inputs, and
// u_input is zero.
#pragma once

#include "verification/case/case_definition.hpp"
#include "verification/evidence/case_runs.hpp"
#include "verification/evidence/record_uncertainty.hpp"
#include "verification/gate/gate.hpp"
#include "verification/gate/three_way_verdict.hpp"

namespace slosh {

// The predictions of theory at both bounds of each declared input's interval. Empty where the case
// declares no inputs, has no row against an experiment, or has no theory inside its range.
std::map<Input, InputBounds> predict_input_bounds(const CaseDefinition& definition,
                                                  const CaseRuns& runs);

// Turns the repeats of coarse runs into input bounds, where theory has left none, and removes these
// runs from the case and its results: they are neither shown nor compared. A repeat that failed or
// has no result stays and is reported as such.
void collect_input_bounds(CaseDefinition& definition, CaseRuns& runs);

// The input uncertainty of a row against an experiment, from runs.input_bounds.
Contribution input_uncertainty(const CaseDefinition& definition, const CaseRuns& runs,
                               const GateRow& row, const MeasureWithSeries& measure_with);

}  // namespace slosh
