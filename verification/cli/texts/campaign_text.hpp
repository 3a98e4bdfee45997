// The text that the tool prints about a campaign.
#pragma once

#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/assessment/problem_assessment.hpp"
#include "verification/campaign/campaign_settings.hpp"
#include "verification/case/campaign_definition.hpp"
#include "verification/engine/progress_display.hpp"

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

// Returns for each run, problem and timing whether its result exists, its expected cost and the
// command that would start it, followed by the sums. Starts nothing.
std::string plan_text(const std::vector<CaseDefinition>& cases,
                      const std::vector<ProblemDefinition>& problems,
                      const CampaignSettings& settings);

}  // namespace slosh
