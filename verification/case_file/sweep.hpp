// Runs that a campaign adds to its cases: one for every combination of the values in a [[sweep]].
//
//   [[sweep]]       cases: names or globs of the campaign's cases
//                   the keys of a [[run]] (run_group.hpp)
//   [[sweep.gate]]  optional; as [[gate]] of a case, without candidate: its rows for each
//                   of these runs
#pragma once

#include <filesystem>
#include <vector>

#include "verification/case/campaign_definition.hpp"

namespace slosh {

// Adds the runs and gate rows of the campaign's sweeps to the case. `experiments` is the directory
// of the user's records. Throws CaseFileError with the line of the campaign file.
void add_swept_runs(const CampaignDefinition& campaign, const std::filesystem::path& experiments,
                    CaseDefinition& definition);

// Throws CaseFileError for a sweep that matches none of these cases.
void require_swept_cases(const CampaignDefinition& campaign,
                         const std::vector<CaseDefinition>& cases);

}  // namespace slosh
