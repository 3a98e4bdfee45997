// The subcommand selftest: whether the gate rows of a campaign detect what they claim to, found out
// on the campaign's own results. Starts no solver.
#pragma once

#include "verification/campaign_command.hpp"

namespace slosh {

// Prints what each row detects. exit_violated where a row lets pass what it must detect,
// exit_not_compared where no row could be tried.
int selftest_campaign(const CampaignOptions& options, const Installation& installation);

}  // namespace slosh
