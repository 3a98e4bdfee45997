// The work-precision points of a case: what its runs and references cost and how far off they are,
// by family (run_cost.hpp).
#pragma once

#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/evidence/run_cost.hpp"

namespace slosh {

// Of the judging comparisons, in the order of the case file.
std::vector<WorkFamily> work_families(const CaseAssessment& assessment);

// Theory of the liquid alone and potential flow, in their range, each a family of one run: the
// error is what sets each apart from the first other one that there is. None where there is one
// alone.
std::vector<WorkFamily> reference_families(const CaseAssessment& assessment);

}  // namespace slosh
