// The work-precision points of a case: the costs and errors of its runs and references, by family
// (run_cost.hpp).
#pragma once

#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/evidence/run_cost.hpp"

namespace slosh {

// The families of the judging comparisons, in the order of the case file.
std::vector<WorkFamily> work_families(const CaseAssessment& assessment);

// Theories of the liquid alone that are inside their range, each as a family of one run. The error
// of each is its difference from the first other one. Empty where there is only one.
std::vector<WorkFamily> reference_families(const CaseAssessment& assessment);

}  // namespace slosh
