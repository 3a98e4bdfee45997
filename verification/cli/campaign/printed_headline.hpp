// What a terminal shows of a judged campaign below its rows.
#pragma once

#include <string>
#include <vector>

#include "reports/summary/headline.hpp"
#include "verification/cli/campaign/requested_campaign.hpp"

namespace slosh {

// The headline with its verdict, and the row that decides it or is nearest to its limit.
std::string verdict_text(const AssessedCampaign& assessed, const std::vector<HeadlineLine>& lines,
                         int status);

// The same, the doubts about runs, and a line for each case and code, which
// begins with how it stands. `status` is that of the verdict.
std::string headline_text(const AssessedCampaign& assessed, int status);

// How many rows hold, how many of the declared ones are judged, and what they rest on: sentences.
std::string rows_text(const AssessedCampaign& assessed);

}  // namespace slosh
