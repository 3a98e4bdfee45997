// What a campaign's last start ended with, so that one that would find nothing else to do says it
// again at once.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "verification/campaign/campaign_settings.hpp"
#include "verification/case_file/campaign_definition.hpp"

namespace slosh {

struct CampaignStanding {
  std::string fingerprint;  // of all that the verdict and the report were made from
  int status;               // the exit status
  std::string out;          // what was told of it
};

// Hashes the campaign's and the cases' files and the tool itself, and of the ledger of baselines,
// of each result and of its timings when it was written; nothing where a result is missing, so that
// something is left to do.
std::optional<std::string> fingerprint_of(const CampaignDefinition& campaign,
                                          const std::vector<CaseDefinition>& cases,
                                          const CampaignSettings& settings,
                                          const std::filesystem::path& ledger);

// <output>/standing.json. Nothing where it is absent or no such file.
std::optional<CampaignStanding> read_standing(const std::filesystem::path& output);
void write_standing(const CampaignStanding& standing, const std::filesystem::path& output);

}  // namespace slosh
