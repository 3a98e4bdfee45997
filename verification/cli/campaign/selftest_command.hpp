// The subcommand selftest: whether the gate rows of a campaign detect what they claim to, found out
// on the campaign's own results. Starts no solver.
#pragma once

#include "verification/cli/campaign/campaign_command.hpp"

namespace slosh {

struct SelftestOptions {
  CampaignOptions campaign;
  bool record = false;  // leave what was found beside the baselines (selftest_record.hpp)
};

// Prints what each row detects, and what the rows of each case detect together. exit_violated where
// a row lets pass what it must detect or detects nothing, or the rows of a case miss together what
// every case must detect (of a part of a campaign, by --only or --tag, that is told and does not
// count); exit_not_compared where no row could be tried. Throws CaseFileError where a part is to be
// recorded.
int selftest_campaign(const SelftestOptions& options, const Installation& installation);

}  // namespace slosh
