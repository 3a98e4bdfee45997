// The files that a path in a case file stands for.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "verification/input/toml_reader.hpp"

namespace slosh {

// Finds case and campaign files, by the name of a shipped one or by a path, and reads them.

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

struct InputFile {
  std::string name;  // of the file, or its path below the directory that is named
  std::filesystem::path file;
};

// Returns a file itself; of a directory all regular files below it, in the order of their names,
// but for those that are hidden or in a hidden directory or in __pycache__; of a pattern, as a
// shell has it, what both return for each path that matches. A directory behind a link counts once.
// Empty where there is nothing. Throws std::filesystem::filesystem_error for a directory that
// cannot be read.
std::vector<InputFile> input_files(const std::filesystem::path& path);

// Refuses the value at a key unless it names data that a case may read: a file, or a directory of
// one program's time folders, below the root of the repository that holds the case file (the
// nearest directory above it with a ".git"), or without a repository below its own directory or a
// current one that holds it; or among the shipped cases. Links are followed, and nothing hidden is
// read. A case that others propose reads nothing else of the machine, and no message quotes from
// it.
void require_data_file(const TomlTable& table, const char* key, const std::filesystem::path& file,
                       const std::filesystem::path& case_file);

// Whether a file that was found may be read so.
bool is_data_of(const std::filesystem::path& case_file, const std::filesystem::path& file);

// Whether there is a regular file below the directory. Throws where links lead out of it.
bool is_record_in(const std::filesystem::path& directory, const TomlTable& table, const char* key,
                  const std::filesystem::path& file);

}  // namespace slosh
