// A campaign as its options ask for it: files read and checked, places settled.
#pragma once

#include <vector>

#include "verification/campaign/campaign_settings.hpp"
#include "verification/case/campaign_definition.hpp"
#include "verification/cli/campaign/campaign_command.hpp"

namespace slosh {

struct RequestedCampaign {
  CampaignDefinition definition;
  std::vector<CaseDefinition> cases;  // with the runs of the campaign's sweeps
  CampaignSettings settings;
  // Of the report and the gate's files: the settings' output, of a selection its folder selected/,
  // so that a part is never taken for the whole.
  std::filesystem::path place;
};

// Throws CaseFileError for all that the campaign and its cases get wrong, before anything runs.
RequestedCampaign requested(const CampaignOptions& options, const Installation& installation);

// "-quick" or nothing: after the name in the places of a campaign's form.
std::string form_of(const CampaignOptions& options);

}  // namespace slosh
