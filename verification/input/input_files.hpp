// The files that a path in a case file stands for.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

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

}  // namespace slosh
