// The reader of campaign files (TOML, verification/campaigns/*.toml), as strict as that of case
// files. The schema, version 1:  schema_version = 1, name, title, source, paper? = "li2010" |
// "zhao2021", cases = [...], each the name of a shipped case or a path (it holds a / or ends in
// .toml) relative to the campaign file.
#pragma once

#include <filesystem>
#include <string>

#include "verification/case_file/campaign_definition.hpp"
#include "verification/case_file/case_file_error.hpp"

namespace slosh {

// Finds every case file but reads none. Throws CaseFileError.
CampaignDefinition read_campaign(const std::filesystem::path& file,
                                 const std::filesystem::path& case_directory);

// As find_case of case_parser.hpp, for campaigns.
std::filesystem::path find_campaign(const std::string& name_or_path,
                                    const std::filesystem::path& directory);

}  // namespace slosh
