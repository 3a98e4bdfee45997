// What `campaign --dry-run` tells.
#pragma once

#include <string>
#include <vector>

#include "verification/campaign/campaign_settings.hpp"
#include "verification/case/campaign_definition.hpp"

namespace slosh {

// Of each run, problem and timing whether its result stands, what it is expected to cost and the
// command that would be started; then the sums. Starts nothing.
std::string plan_text(const std::vector<CaseDefinition>& cases,
                      const std::vector<ProblemDefinition>& problems,
                      const CampaignSettings& settings);

}  // namespace slosh
