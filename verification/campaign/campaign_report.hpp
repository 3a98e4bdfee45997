// Puts the assessed cases of a campaign into a report.
#pragma once

#include <string>
#include <vector>

#include "reports/report_model.hpp"
#include "verification/campaign/case_assessment.hpp"
#include "verification/case_file/campaign_definition.hpp"

namespace slosh {

reports::Report campaign_report(const CampaignDefinition& campaign, bool quick,
                                const std::vector<CaseAssessment>& cases);

// "PASS: ...", "FAIL: ...": one sentence on the whole.
std::string verdict_sentence(const std::vector<CaseAssessment>& cases);

}  // namespace slosh
