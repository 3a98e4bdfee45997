// What an experiment's uncertain inputs make of a gate row that compares with it: the input
// uncertainty of ASME V&V 20-2009, section 4, by central differences of the metric's prediction,
//   u_input^2 = sum over inputs of ((m(x + u) - m(x - u)) / 2)^2
// with u the half width that the case declares of the input x and m the row's metric, measured with
// a prediction of the tank with that input in the candidate's place. The prediction is that of the
// case's linear theory or potential flow where one of them is inside its range, else that of the
// input's coarse run, repeated at both ends: its difference holds the scatter of two single runs
// too, and so is too large rather than too small where the motion is chaotic. With neither, the
// row's u_input is unknown. Against theory or another method both sides are told the same inputs:
// none.
#pragma once

#include "verification/case/case_definition.hpp"
#include "verification/evidence/case_runs.hpp"
#include "verification/gate/gate.hpp"
#include "verification/gate/three_way_verdict.hpp"

namespace slosh {

// What theory predicts at both ends of each declared input's interval; nothing where the case
// declares none, has no row against an experiment, or has no theory inside its range.
std::map<Input, InputBounds> predict_input_bounds(const CaseDefinition& definition,
                                                  const CaseRuns& runs);

// Makes input bounds of the repeats of coarse runs, where theory has left none, and takes these
// runs out of the case and of its results: nothing is to be shown of them or compared with them.
// One that failed, or that another start must finish, stays and is told as such.
void take_runs_at_ends(CaseDefinition& definition, CaseRuns& runs);

// Of a row against an experiment, from runs.input_bounds.
Contribution input_uncertainty(const CaseDefinition& definition, const CaseRuns& runs,
                               const GateRow& row);

}  // namespace slosh
