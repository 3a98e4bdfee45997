// The text that the tool prints about an assessed campaign.
#pragma once

#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/assessment/problem_assessment.hpp"

namespace slosh {

// Returns a line for each run and problem without a result: the reason, followed by the output of
// the failed program.
std::string complaints(const std::vector<CaseAssessment>& cases,
                       const std::vector<ProblemAssessment>& problems);

// Returns a line for each gate row, which begins with the verdict.
std::string gate_lines(const std::vector<CaseAssessment>& cases,
                       const std::vector<ProblemAssessment>& problems);

}  // namespace slosh
