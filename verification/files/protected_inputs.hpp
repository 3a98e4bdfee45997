// The files that this process was given to read. No output may take the place of one of them.
#pragma once

#include <filesystem>
#include <stdexcept>

namespace slosh {

// An output was asked for where an input lies. It is not a runtime_error, so that no handler of
// failed writes takes it for one.
struct OutputError : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

// Of two paths without links and dots: whether the file is the directory or lies below it.
bool lies_below(const std::filesystem::path& file, const std::filesystem::path& directory);

// Makes the file an input of this process. Does nothing where there is none.
void protect_input(const std::filesystem::path& file);

// Throws OutputError where the output, or what it leads to by a symbolic or a hard link, is an
// input, and where it is a directory that holds one.
void require_no_input(const std::filesystem::path& output);

}  // namespace slosh
