// The parser of campaign files (TOML, verification/campaigns/*.toml). It is as strict as that of
// case files. key_table.hpp lists the keys.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/case/campaign_definition.hpp"
#include "verification/input/case_file_error.hpp"

namespace slosh {

// Finds the case files but does not read them. A case file is read as the campaign of this case
// alone, with its name. Throws CaseFileError.
CampaignDefinition read_campaign(const std::filesystem::path& file,
                                 const std::filesystem::path& case_directory,
                                 const std::vector<KnownProblem>& known_problems);

// Finds the file of a campaign, as find_case() in case_parser.hpp does for a case.
std::filesystem::path find_campaign(const std::string& name_or_path,
                                    const std::filesystem::path& directory);

// Runs that a campaign adds to its cases: one for every combination of the values in a [[sweep]].
//
//   [[sweep]]       cases: names or globs of the campaign's cases
//                   the keys of a [[run]]
//   [[sweep.gate]]  optional; as [[gate]] of a case, without candidate: its rows for each
//                   of these runs

// Adds the runs and gate rows of the campaign's sweeps to the case. Throws CaseFileError with the
// line of the campaign file.
void add_swept_runs(const CampaignDefinition& campaign, CaseDefinition& definition);

// Throws CaseFileError for a sweep that matches none of these cases.
void require_swept_cases(const CampaignDefinition& campaign,
                         const std::vector<CaseDefinition>& cases);

}  // namespace slosh
