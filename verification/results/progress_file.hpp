// How a run tells the process that started it how far it is: a small JSON file that is replaced as
// a whole.
#pragma once

#include <filesystem>
#include <optional>

namespace slosh {

struct RunProgress {
  double time = 0;      // [s], simulated
  double end_time = 0;  // [s]
  double steps = 0;
};

// Throws std::filesystem::filesystem_error.
void write_progress(const RunProgress& progress, const std::filesystem::path& file);

// Nothing where the file is absent or is no progress file: a run may not have begun to write.
std::optional<RunProgress> read_progress(const std::filesystem::path& file);

}  // namespace slosh
