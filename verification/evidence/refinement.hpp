// The numerical uncertainty of a gate row's metric, from runs of its case that differ in one number
// alone. The metric is measured with each of them in the place of the run that the row names, and
// discretisation_uncertainty.hpp judges its convergence at the step of that run, which may be any
// of them. For two runs alone, with h2 > h1,
//   U(h) = 3 |f2 - f1| max(1, h / (h2 - h1))
// (the grid convergence index with a safety factor of 3 for an error of first order; Roache 1998,
// section 5.6). For the coarser run this covers its whole error at first order, not only the
// difference.
//
// A metric may have one value for two series that differ (BlindTo). With f the finest series and g
// a coarser one, its value there is then taken as
//   m(f) + max(|m(g) - m(f)|, |m(f + s (g - f)) - m(f)|)
// with s = -1 for a distance, as far the other way, and s = 1/2 for a modulus, which vanishes half
// way to a wave that is turned over; and the larger of both uncertainties counts. A share of the
// time, which may be 0 at both, has its largest change as the series moves by its own U to either
// side, where that is more.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/convergence/discretisation_uncertainty.hpp"
#include "verification/evidence/case_runs.hpp"
#include "verification/evidence/record_uncertainty.hpp"
#include "verification/gate/gate.hpp"

namespace slosh {

// Returns a row's metric with the interval that its time series give it.
using MeasureRow = std::function<Estimate(const GateRow& row)>;

// Measure a row as it is, and with another series in the place of a run's.
struct PathMeasures {
  MeasureRow row;
  MeasureWithSeries with_series;
};

// The step of a run on a refinement path, in an arbitrary unit. Throws ComparisonError where its
// result does not record it.
double step_of(RefinedNumber number, const RunDefinition& run, const CaseRuns& runs);

enum class Role { candidate, reference };

struct RefinedMetric {
  std::string path;
  std::vector<std::string> runs;    // coarse to fine
  std::vector<ValueAtStep> values;  // likewise
  DiscretisationUncertainty found;  // about the value of the run that the row names
};

struct Refinements {
  std::vector<RefinedMetric> paths;
  std::vector<std::string> unknown;  // why another path of the run tells nothing
};

// The metric on each path of the case that holds the row's candidate (or reference), for all runs
// that can be measured. A path is left out where that run or all others cannot be measured. Of runs
// whose steps differ by less than least_refinement_ratio one counts: the row's own, or else the
// first. A path tells nothing where a single step is left, where the finer of two spacings of a
// user's program has no more particles by its own result, and where two of its steps have the same
// series in the window, to a millionth, or differ by noise alone: by white noise of a tenth of the
// series at most, or by less than a thousandth at three steps, in no order. One of them is not what
// it claims to be.
Refinements refined_metrics(const CaseDefinition& definition, const CaseRuns& runs,
                            const GateRow& row, Role role, const PathMeasures& measures);

// Whether two series have the same values in the window, to a millionth of the largest; at times
// that the other lacks to what a straight line between its samples may miss. A finer resolution
// changes the answer of every solver by more.
bool are_same(const TimeSeries& one, const TimeSeries& other, TimeWindow window);

// The root of the sum of squares of the paths' uncertainties.
double numerical_uncertainty(const std::vector<RefinedMetric>& paths);

}  // namespace slosh
