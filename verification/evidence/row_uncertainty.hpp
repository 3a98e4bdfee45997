// The uncertainties of a gate row's metric beside its own interval, after ASME V&V 20.
//   reference       A record has the uncertainty that its publisher states, or an unknown one. A
//                   solver such as interFoam has its numerical uncertainty, which is unknown for a
//                   run on no refinement path. A theory has the changes of the metric as the theory
//                   moves by what it leaves beside its series, both ways: for potential flow to the
//                   flow with fewer nodes; for linear theory to that with more modes, times 2.5 for
//                   a rest that falls with the first power of their number (a factor of 2, and 1.25
//                   of Celik et al. 2008), and to the estimate of the third order
//                   (beyond_linear.hpp), which the viscous wave has too.
//   discretisation  Against an experiment this is the candidate's numerical uncertainty, which is
//                   unknown for a run on no refinement path. Against theory or another method it is
//                   zero: the candidate's discretisation error is what the row measures. A row
//                   without a reference judges the run with the spacing that it has.
//   time_series     A flow that is sensitive to small disturbances has the spread of its repeats.
//   input           Against an experiment this is the effect of its uncertain inputs. Where the
//                   candidate is an ensemble that draws them (vary_inputs), it is the interval in
//                   which 95 % of its members lie, t_(0.975, n-1) s, in the place of that of
//                   [[input]]: the scatter already holds it. Against
//                   theory or another method it is zero: both sides have the same inputs.
// A cost has the interval of its timings alone. A p-value has that of its permutations alone: the
// test is of the ensemble as it is, numerical errors and inputs included.
#pragma once

#include <functional>

#include "verification/case/case_definition.hpp"
#include "verification/evidence/case_runs.hpp"
#include "verification/evidence/record_uncertainty.hpp"
#include "verification/evidence/refinement.hpp"
#include "verification/gate/gate.hpp"
#include "verification/gate/three_way_verdict.hpp"
#include "verification/metrics/comparison.hpp"

namespace slosh {

// Whether the row compares with measurements of a real tank: a record, or published impacts.
bool rests_on_experiment(const CaseDefinition& definition, const GateRow& row);

// Whether the verdict counts what the inputs' intervals do to the candidate, measured at their
// bounds. A regression row has the same inputs as before, and some ensembles draw their inputs.
bool rests_on_input_bounds(const CaseDefinition& definition, const GateRow& row);

// The functions that measure a row's uncertainties. They throw ComparisonError or ResultError where
// there is nothing to measure.
struct RowMeasures {
  FindComparison comparison = {};  // of the row's candidate and reference
  MeasureRow measure;
  // Measures against the reference moved by a share of its distance from the series with this
  // suffix that it leaves beside its own (SolverKind::leaves).
  std::function<Estimate(const GateRow&, const std::string& suffix, double share)>
      measure_against_moved = {};
  // input_uncertainty() of a row that rests on an experiment.
  std::function<Contribution(const GateRow&)> input = {};
  // Measures each member of the candidate against each of the reference (measured_value.hpp).
  std::function<std::vector<std::vector<Estimate>>(const GateRow&)> pairs = {};
  MeasureWithSeries measure_with = {};
};

UncertaintyContributions row_uncertainty(const CaseDefinition& definition, const CaseRuns& runs,
                                         const GateRow& row, const RowMeasures& measures);

}  // namespace slosh
