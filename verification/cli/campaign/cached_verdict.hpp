// The verdict of a campaign's last start. A start that finds nothing new prints it again at once.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "verification/campaign/campaign_settings.hpp"
#include "verification/case/campaign_definition.hpp"

namespace slosh {

struct CachedVerdict {
  std::string fingerprint;  // hash of everything that determines the verdict and the report
  int status;               // the exit status
  std::string out;          // what was printed
};

// Returns a hash of the campaign's and the cases' files, of `judge`, which is that of the tool
// before the campaign began, and of the whole content of each result, of its timings and of the
// cases' tables of peaks; sizes and time stamps do not identify a content. Returns nullopt if a
// result is missing, so that there is something to do.
std::optional<std::string> fingerprint_of(const CampaignDefinition& campaign,
                                          const std::vector<CaseDefinition>& cases,
                                          const CampaignSettings& settings,
                                          const std::string& judge);

// Reads <output>/standing.json. Returns nullopt if it is absent, if a file of <output>/report has
// been edited or removed since or, with a message, if it is unusable.
std::optional<CachedVerdict> read_cached_verdict(const std::filesystem::path& output);
// Called before the report is replaced: a cached verdict must belong to the existing report.
void forget_cached_verdict(const std::filesystem::path& output);
void write_cached_verdict(const CachedVerdict& cached, const std::filesystem::path& output);

}  // namespace slosh
