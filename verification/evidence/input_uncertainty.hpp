// The input uncertainty of a gate row that compares with an experiment (ASME V&V 20-2009, section
// 4), by the largest change of the metric's prediction from its own value,
//   u_input^2 = sum over inputs of max over s of |m(x + s u) - m(x)|^2
// u is the half width that the case declares for the input x, and m is the row's metric, measured
// with a prediction for the tank with that input in the place of the candidate, at both bounds, s =
// -1 and 1, and of theory at as many places between them as a periodic response needs: 32 while it
// repeats itself once. It does so within a turn of the start's phase, a length of the shortest wave
// that carries much, and what turns the phase at the window's end once of a period, a depth or
// gravity. A start that is wider than half a turn may be anywhere; any other input that is wider
// than half a repeat has no known effect, as no such number of places shows it. Runs are made at
// the bounds alone, so that their interval must be short (a twentieth of a repeat). A central
// difference would be zero where m is a magnitude, such as normalised_rms, with its least value at
// x. The prediction comes from the case's first theory of the liquid alone that is inside its
// range, otherwise from the input's coarse run, repeated at both bounds. The difference of two
// coarse runs includes their scatter: where the flow is chaotic it is too large rather than too
// small. An input that cannot be propagated (a bound at which no tank is possible, no prediction at
// both bounds) is named in `not_counted`; the other inputs count. Without any, the row's u_input is
// unknown. Against theory or another method both sides have the same inputs, and u_input is zero.
#pragma once

#include "verification/case/case_definition.hpp"
#include "verification/evidence/case_runs.hpp"
#include "verification/evidence/record_uncertainty.hpp"
#include "verification/gate/gate.hpp"
#include "verification/gate/three_way_verdict.hpp"

namespace slosh {

// Adds the predictions of theory at both bounds of each declared input's interval, or why theory
// fails there. Adds nothing where the case declares no inputs, has no row against an experiment, or
// has no theory inside its range.
void predict_input_bounds(const CaseDefinition& definition, CaseRuns& runs);

// Turns the repeats of coarse runs into input bounds, where theory has left none, and removes these
// runs from the case and its results: they are neither shown nor compared. A repeat that failed or
// has no result stays and is reported as such.
void collect_input_bounds(CaseDefinition& definition, CaseRuns& runs);

// The input uncertainty of a row against an experiment, from runs.input_bounds.
Contribution input_uncertainty(const CaseDefinition& definition, const CaseRuns& runs,
                               const GateRow& row, const MeasureWithSeries& measure_with);

}  // namespace slosh
