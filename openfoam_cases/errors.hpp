// The errors of this folder: an impossible tank, and a run without a usable result.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace slosh::openfoam {

// Throws std::invalid_argument, with the key, its value and what was expected, unless the condition
// holds.
void require(bool condition, const char* key, double value, const std::string& expected);

// A run that gave no usable result. what() gives the stage (blockMesh, interFoam, ...), what went
// wrong (missing program, exit status, signal, incomplete output, warning), the log and its
// relevant lines. Each part is also a member of its own.
struct RunError : std::runtime_error {
  explicit RunError(const std::string& what_went_wrong, const std::filesystem::path& log_file = {},
                    const std::string& lines = "");

  std::string message;        // one line
  std::filesystem::path log;  // of the program; empty where it left none
  std::string words;          // the program's own output, line by line
};

// Throws a RunError about this file of interFoam's output.
[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& what);

}  // namespace slosh::openfoam
