// What an experiment's uncertain inputs make of a gate row that compares with it: the input
// uncertainty of ASME V&V 20-2009, section 4, by central differences of the metric's prediction,
//   u_input^2 = sum over inputs of ((m(x + u) - m(x - u)) / 2)^2
// with u the half width that the case declares of the input x and m the row's metric, measured with
// what theory says of the tank with that input in the candidate's place. Valid where the case has a
// run of linear theory or of potential flow inside its range; without one the row's u_input is
// unknown. Against theory or another method both sides are told the same inputs: none.
#pragma once

#include "verification/campaign/case_runs.hpp"
#include "verification/case_file/case_definition.hpp"
#include "verification/gate/gate.hpp"
#include "verification/gate/three_way_verdict.hpp"

namespace slosh {

// The case with one input greater by `change` [the input's unit]. A table's times are stretched by
// its period, its values by its amplitude; gauges move along x, or along their wall.
CaseDefinition with_input(CaseDefinition definition, Input input, double change);

// What theory predicts at both ends of each declared input's interval; nothing where the case
// declares none, has no row against an experiment, or has no theory inside its range.
std::map<Input, InputBounds> predict_input_bounds(const CaseDefinition& definition,
                                                  const CaseRuns& runs);

// Of a row against an experiment, from runs.input_bounds.
Contribution input_uncertainty(const CaseDefinition& definition, const CaseRuns& runs,
                               const GateRow& row);

}  // namespace slosh
