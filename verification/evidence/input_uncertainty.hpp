// The input uncertainty of a gate row that compares with an experiment (ASME V&V 20-2009, section
// 4): how far the row's metric m may move as each input x moves within its declared half width u,
//   u_input^2 = sum over inputs of max over s of |m(x + s u) - m(x)|^2
// m is measured with the candidate. A run is not repeated with other inputs: its answer c is taken
// to follow a prediction p, by theory or by a coarse run, as c(x + s u) = c p(x + s u) / p(x), in
// each mode by amplitude, phase, frequency and decay. So the result is the same where the
// prediction is half as high as the candidate or lags behind it:
//   an error of a ratio c / r   (1 + m) |p(x + s u) / p(x) - 1|
//   a difference c - r          |p(x + s u) - p(x)|
//   a distance                  that of p(x + s u) from p(x), times the candidate's deviation from
//                               its mean over p(x)'s; the shift of the mean as it is. No distance
//                               moves by more (the triangle inequality).
//   a share outside a band      measured with c moved by p(x + s u) - p(x), its swing so enlarged
// s is -1 and 1, and for theory as many places between them as a periodic response needs: 32 while
// it repeats itself once. It does so within a turn of the start's phase, a length of the shortest
// wave that carries much, and what turns the phase at the window's end once of a period, a depth or
// gravity. A start that is wider than half a turn may be anywhere; any other input that is wider
// than half a repeat has no known effect, as no such number of places shows it. Runs are made at
// the bounds alone, so that their interval must be short (a twentieth of a repeat).
//
// The prediction comes from the case's first theory of the liquid alone that is inside its range
// and sees the input: viscosity is seen by the viscous wave alone, and so is what any input does to
// a decay. Otherwise it comes from the input's coarse run, repeated at both bounds. The difference
// of two coarse runs includes their scatter: where the flow is chaotic it is too large rather than
// too small. An input that cannot be propagated (a bound at which no tank is possible, no
// prediction at both bounds, coarse runs that it does not change) is named in `not_counted`; the
// other inputs count. Without any, the row's u_input is unknown. Against theory or another method
// both sides have the same inputs, and u_input is zero.
#pragma once

#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/evidence/case_runs.hpp"
#include "verification/evidence/record_uncertainty.hpp"
#include "verification/gate/gate.hpp"
#include "verification/gate/three_way_verdict.hpp"

namespace slosh {

// Whether the run is a theory that may tell what the input does: of the liquid alone, and it sees
// the input.
bool may_predict(const RunDefinition& run, Input input);

// Adds the predictions of theory at both bounds of each declared input's interval, or why theory
// fails there. Adds nothing where the case declares no inputs, has no row against an experiment, or
// has no theory inside its range that sees the input.
void predict_input_bounds(const CaseDefinition& definition, CaseRuns& runs);

// Turns the repeats of coarse runs into input bounds, where theory has left none, and removes these
// runs from the case and its results: they are neither shown nor compared. A repeat that failed or
// has no result stays and is reported as such.
void collect_input_bounds(CaseDefinition& definition, CaseRuns& runs);

// The largest change of a row's metric that one input's predictions show, apart from what the
// candidate is.
struct InputEffect {
  std::string input;         // its name
  double of_wave = 0;        // over the candidate's scale
  double of_mean = 0;        // of a distance: the shift of the mean, in the quantity's unit
  std::string unknown = {};  // why it is not known
};

// By what an effect is multiplied: 1 + m of a ratio, 1 of a difference, the candidate's deviation
// over the reference's of a distance; and of its shift of the mean 1 over the reference's
// deviation.
struct CandidateScale {
  double wave = 1, mean = 0;
};

// One for each declared input of the case, for a row against an experiment. The effects on a share
// outside a band are of this candidate; all others are of any.
std::vector<InputEffect> input_effects(const CaseDefinition& definition, const CaseRuns& runs,
                                       const GateRow& row, const MeasureWithSeries& measure_with);

// The scale of the row's candidate, whose metric has this value. Throws what `comparison` throws.
CandidateScale candidate_scale(const CaseDefinition& definition, const GateRow& row, double value,
                               const FindComparison& comparison);

Contribution input_uncertainty(const std::vector<InputEffect>& effects, const GateRow& row,
                               const CandidateScale& scale);

}  // namespace slosh
