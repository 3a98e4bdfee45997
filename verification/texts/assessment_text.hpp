// The text that the tool prints about an assessed campaign.
#pragma once

#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/assessment/problem_assessment.hpp"
#include "verification/display/progress_display.hpp"

namespace slosh {

// Formats lines of verdicts for a terminal or a file.

// On a terminal, lines longer than its width are broken between words and indented, and the verdict
// at the beginning of a line is coloured if colours are allowed (green: passed; red: violated or
// solver failed; yellow: undecided). Elsewhere the text is unchanged.
std::string as_shown(const std::string& text, const DisplayStyle& style);

// Returns a line for each run and problem without a result: the reason, followed by the output of
// the failed program.
std::string complaints(const std::vector<CaseAssessment>& cases,
                       const std::vector<ProblemAssessment>& problems);

// Returns a line for each gate row, which begins with the verdict.
std::string gate_lines(const std::vector<CaseAssessment>& cases,
                       const std::vector<ProblemAssessment>& problems);

}  // namespace slosh
