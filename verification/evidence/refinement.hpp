// The numerical uncertainty of a gate row's metric, from runs of its case that are alike but for
// one number: the metric is measured with each of them in the place of the run that the row names,
// and what it does as the step falls is judged by discretisation_uncertainty.hpp at the step of
// that run, which may be any of them. Of two runs alone, with h2 > h1,
//   U(h) = 3 |f2 - f1| max(1, h / (h2 - h1))
// (grid convergence index with a safety factor of 3 on an error of the first order; Roache 1998,
// section 5.6): of the coarser run that is its whole error at first order, not the difference.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/convergence/discretisation_uncertainty.hpp"
#include "verification/evidence/case_runs.hpp"
#include "verification/gate/gate.hpp"

namespace slosh {

// A row's metric with the interval that its time histories give it.
using MeasureRow = std::function<Estimate(const GateRow& row)>;

// The step of a run on a refinement path, in whatever unit; throws ComparisonError where its result
// does not tell it.
double step_of(RefinedNumber number, const RunDefinition& run, const CaseRuns& runs);

enum class Role { candidate, reference };

struct RefinedMetric {
  std::string path;
  std::vector<std::string> runs;    // coarse to fine
  std::vector<ValueAtStep> values;  // likewise
  DiscretisationUncertainty found;  // about the value of the run that the row names
};

// Of each path of the case on which the row's candidate, or reference, stands: all runs that can be
// measured. Paths of which that run itself or every other one cannot be measured are left out.
std::vector<RefinedMetric> refined_metrics(const CaseDefinition& definition, const CaseRuns& runs,
                                           const GateRow& row, Role role,
                                           const MeasureRow& measure);

// The uncertainties of all paths together.
double numerical_uncertainty(const std::vector<RefinedMetric>& paths);

}  // namespace slosh
