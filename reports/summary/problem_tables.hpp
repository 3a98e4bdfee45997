// A problem's section of a report, on the page of the problems.
#pragma once

#include "reports/model/report_model.hpp"
#include "verification/assessment/problem_assessment.hpp"

namespace slosh {

// The statement, the source, the exact solution, errors and observed orders over the resolutions,
// the errors drawn, the problem's own figures, and the limits with their reasons.
reports::Section problem_section(const ProblemAssessment& assessment);

}  // namespace slosh
