// The report of a campaign with its assessed cases and problems.
#pragma once

#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"
#include "verification/assessment/problem_assessment.hpp"
#include "verification/case/campaign_definition.hpp"

namespace slosh {

// `command` is the command that repeats the campaign.
reports::Report campaign_report(const CampaignDefinition& campaign, bool quick,
                                const std::string& command,
                                const std::vector<CaseAssessment>& cases,
                                const std::vector<ProblemAssessment>& problems = {});

// Of an exit status.
reports::Outcome outcome_of(int status);

}  // namespace slosh
