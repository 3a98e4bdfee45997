// The progress of a run, for the process that started it: a small JSON file that is replaced as a
// whole.
#pragma once

#include <filesystem>
#include <optional>

namespace slosh {

struct RunProgress {
  double time = 0;      // [s], simulated
  double end_time = 0;  // [s]
  double steps = 0;
};

// Replaces the file. Throws std::filesystem::filesystem_error.
void write_progress(const RunProgress& progress, const std::filesystem::path& file);

// Throws std::filesystem::filesystem_error where a file lies there that is no progress, and
// OutputError (protected_inputs.hpp) where it is an input of this process.
void require_progress_place(const std::filesystem::path& file);

// Returns nullopt where the file is absent or not readable: the run may not have begun to write it.
std::optional<RunProgress> read_progress(const std::filesystem::path& file);

}  // namespace slosh
