// Puts the assessed cases and problems of a campaign into a report.
#pragma once

#include <string>
#include <vector>

#include "reports/report_model.hpp"
#include "verification/campaign/case_assessment.hpp"
#include "verification/campaign/known_strengths.hpp"
#include "verification/campaign/problem_assessment.hpp"
#include "verification/case_file/campaign_definition.hpp"

namespace slosh {

// `command` repeats the campaign. What the gate rows detect is looked up in `known` first and kept
// there; it may be null.
reports::Report campaign_report(const CampaignDefinition& campaign, bool quick,
                                const std::string& command,
                                const std::vector<CaseAssessment>& cases,
                                const std::vector<ProblemAssessment>& problems = {},
                                KnownStrengths* known = nullptr);

// "19 of 19 gate rows hold, 12 not selected."
std::string verdict_sentence(const std::vector<CaseAssessment>& cases,
                             const std::vector<ProblemAssessment>& problems = {});

}  // namespace slosh
