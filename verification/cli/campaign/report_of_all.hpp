// `report --all`: one page over all campaigns whose reports lie in a directory.
#pragma once

#include <atomic>

#include "verification/cli/campaign/campaign_options.hpp"

namespace slosh {

// Reads DIR/NAME/report/results.json of each campaign, DIR being the options' output or else
// build/campaigns, and leaves DIR/report. Returns the worst of their exit statuses. Throws
// CaseFileError where there is no such file.
int report_of_all(const CampaignOptions& options, const Installation& installation,
                  const std::atomic<bool>& stop);

}  // namespace slosh
