// Case and campaign files on disk: found by the name of a shipped one or by a path, and read.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace slosh {

// A path (it holds a / or ends in .toml) from `base`, or <directory>/<name>.toml. `kind` is "case"
// or "campaign", for the message. Throws CaseFileError when there is no such file, with the nearest
// names in the directory.
std::filesystem::path find_definition_file(std::string_view kind, const std::string& name_or_path,
                                           const std::filesystem::path& directory,
                                           const std::filesystem::path& base);

// The whole file. Throws CaseFileError when it cannot be read.
std::string read_definition_text(std::string_view kind, const std::filesystem::path& file);

}  // namespace slosh
