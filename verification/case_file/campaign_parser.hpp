// The parser of campaign files (TOML, verification/campaigns/*.toml). It is as strict as that of
// case files. key_table.hpp lists the keys; sweep.hpp reads [[sweep]].
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

}  // namespace slosh
