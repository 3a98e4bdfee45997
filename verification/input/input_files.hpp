// The files that a path in a case file stands for.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/input/toml_reader.hpp"

namespace slosh {

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
