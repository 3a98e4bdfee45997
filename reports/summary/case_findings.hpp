// What the tables of a case find, in sentences for its summary.
#pragma once

#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/sensitivity/case_coverage.hpp"

namespace slosh {

// Whether a gate row judges against this reference, or against the impacts that a record publishes.
bool is_judged_against(const CaseDefinition& definition, const std::string& reference);

// Says which solution stands apart from the others; how the error of each scheme falls with its
// spacing; how far the runs are from a record that no gate row judges against; and which of the
// errors that are made on purpose no gate row detects. A sentence is left out where the case has
// too few runs for it.
std::vector<std::string> case_findings(const CaseAssessment& assessment,
                                       const CaseCoverage& coverage);

}  // namespace slosh
