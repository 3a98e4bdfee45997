// What the refinement paths of a case say, and what would make an inconclusive row conclusive.
#pragma once

#include <optional>

#include "reports/report_model.hpp"
#include "verification/campaign/case_assessment.hpp"

namespace slosh {

// Of each path, for every metric that a gate row measures on the path's finest run: the values,
// coarse to fine, how they behave, the order, what they tend to and the uncertainty of the finest.
// Nothing without paths.
std::optional<reports::Table> refinement_table(const CaseAssessment& assessment);

// Of each inconclusive row: the contributions to its uncertainty, what that would have to fall to,
// and by which step or window that is reached at what cost. Nothing where no row is inconclusive.
std::optional<reports::Table> remedy_table(const CaseAssessment& assessment);

}  // namespace slosh
