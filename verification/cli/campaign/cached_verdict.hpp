// What a campaign's last start ended with, so that one that would find nothing else to do says it
// again at once.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "verification/campaign/campaign_settings.hpp"
#include "verification/case/campaign_definition.hpp"

namespace slosh {

struct CachedVerdict {
  std::string fingerprint;  // of all that the verdict and the report were made from
  int status;               // the exit status
  std::string out;          // what was told of it
};

// What judges beside the results: the content of the tool and of the ledger of baselines. It is to
// be asked for before a campaign, which takes hours in which either may be replaced.
std::string judges_of(const CampaignSettings& settings, const std::filesystem::path& ledger);

// Hashes the campaign's and the cases' files, the judges, and the whole content of each result, of
// its timings and of the cases' tables of peaks: a size and a time stamp tell nothing of what a
// file holds. Nothing where a result is missing, so that something is left to do.
std::optional<std::string> fingerprint_of(const CampaignDefinition& campaign,
                                          const std::vector<CaseDefinition>& cases,
                                          const CampaignSettings& settings,
                                          const std::string& judges);

// <output>/standing.json. Nothing where it is absent, nor, which is told, where it is no such file.
std::optional<CachedVerdict> read_cached_verdict(const std::filesystem::path& output);
// To be called before the report is replaced: what is said again must be of the report that stands.
void forget_cached_verdict(const std::filesystem::path& output);
void write_cached_verdict(const CachedVerdict& cached, const std::filesystem::path& output);

}  // namespace slosh
