// The reader of campaign files (TOML, verification/campaigns/*.toml), as strict as that of case
// files. The schema, version 1:  schema_version = 1, name, title, source, paper? = "li2010" |
// "zhao2021", cases? = [...], each the name of a shipped case or a path (it holds a / or ends in
// .toml) relative to the campaign file, [[problem]]? with the name of a problem and its gate rows
// [[problem.gate]]: measure (one of the problem's), metric = "order_at_least" | "error_at_finest" |
// "largest_error" with limit, or "order_within" with lower and upper; unit, reason, source. At
// least one case or problem. [[sweep]]? as sweep.hpp says; [timing]? with repeats, longest_run_s?
// and only? = [patterns CASE or CASE/RUN]: which runs are repeated for their timings.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/case_file/campaign_definition.hpp"
#include "verification/case_file/case_file_error.hpp"

namespace slosh {

// Finds every case file but reads none. Throws CaseFileError.
CampaignDefinition read_campaign(const std::filesystem::path& file,
                                 const std::filesystem::path& case_directory,
                                 const std::vector<KnownProblem>& known_problems);

// As find_case of case_parser.hpp, for campaigns.
std::filesystem::path find_campaign(const std::string& name_or_path,
                                    const std::filesystem::path& directory);

}  // namespace slosh
