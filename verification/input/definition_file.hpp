// Finds case and campaign files, by the name of a shipped one or by a path, and reads them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace slosh {

// Returns a path (it contains a / or ends in .toml) relative to `base`, or <directory>/<name>.toml.
// `kind` is "case" or "campaign", for the message. Throws CaseFileError with the nearest names in
// the directory if there is no such file.
std::filesystem::path find_definition_file(std::string_view kind, const std::string& name_or_path,
                                           const std::filesystem::path& directory,
                                           const std::filesystem::path& base);

// Returns the path without "." and ".." where it then still names the same file: behind a link to a
// directory "link/.." is not where the link stands.
std::filesystem::path plain_path(const std::filesystem::path& path);

// Returns the text of the file. Throws CaseFileError if it cannot be read.
std::string read_definition_text(std::string_view kind, const std::filesystem::path& file);

}  // namespace slosh
