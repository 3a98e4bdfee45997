// The output of `campaign --dry-run`.
#pragma once

#include <string>
#include <vector>

#include "verification/campaign/campaign_settings.hpp"
#include "verification/case/campaign_definition.hpp"

namespace slosh {

// Returns for each run, problem and timing whether its result exists, its expected cost and the
// command that would start it, followed by the sums. Starts nothing.
std::string plan_text(const std::vector<CaseDefinition>& cases,
                      const std::vector<ProblemDefinition>& problems,
                      const CampaignSettings& settings);

}  // namespace slosh
