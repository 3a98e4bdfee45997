// How uncertain a case's gate rows are and why, what its refinement paths say, and what would make
// an inconclusive row conclusive.
#pragma once

#include <optional>
#include <string>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"

namespace slosh {

// "u_num 0 %, u_input unknown, u_reference 1.2 %" of a row in that unit.
std::string uncertainties_text(const ThreeWayOutcome& judged, const std::string& unit);

// Of each judged row: its kind, the three uncertainties of ASME V&V 20 and that of the time
// histories, what they amount to and what they rest on, or what is missing. Nothing without rows
// with a limit or a range.
std::optional<reports::Table> uncertainty_table(const CaseAssessment& assessment);

// Of each path, for every metric that a gate row measures on the path's finest run: the values,
// coarse to fine, how they behave, the order, what they tend to and the uncertainty of the finest.
// Nothing without paths.
std::optional<reports::Table> refinement_table(const CaseAssessment& assessment);

// Of each inconclusive row: the contributions to its uncertainty, what that would have to fall to,
// and by which step or window that is reached at what cost. Nothing where no row is inconclusive.
std::optional<reports::Table> remedy_table(const CaseAssessment& assessment);

}  // namespace slosh
