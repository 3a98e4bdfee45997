// Runs that a campaign adds to its cases: every combination of what a [[sweep]] lists.
//
//   [[sweep]]  cases (names or globs of the campaign's cases), name (of each run: "{key}" is the
//              value at that key, its '.' written as 'p'), and the keys of a [[run]], any value of
//              which may be an array of values
//   [[sweep.gate]]?  as [[gate]] of a case, without candidate: a row for each of these runs
#pragma once

#include <filesystem>
#include <vector>

#include "verification/case/campaign_definition.hpp"

namespace slosh {

// Adds to the case what the campaign's sweeps ask of it; `experiments` as read_case() takes it.
// Throws CaseFileError with the campaign file's line.
void add_swept_runs(const CampaignDefinition& campaign, const std::filesystem::path& experiments,
                    CaseDefinition& definition);

// Throws CaseFileError for a sweep over none of these cases.
void require_swept_cases(const CampaignDefinition& campaign,
                         const std::vector<CaseDefinition>& cases);

}  // namespace slosh
