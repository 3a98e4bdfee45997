// Puts the assessed cases and problems of a campaign into a report.
#pragma once

#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"
#include "verification/assessment/problem_assessment.hpp"
#include "verification/case/campaign_definition.hpp"
#include "verification/sensitivity/known_strengths.hpp"

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
