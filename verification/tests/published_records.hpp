// Where a test finds published records, which are not part of the source tree: in the directory
// that SLOSH_EXPERIMENTS names, else in shared/experiments beside the source tree.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

namespace slosh {

// A test that needs a record says so and is skipped where this is empty.
inline std::optional<std::filesystem::path> published_record(const std::string& name) {
  const char* named = std::getenv("SLOSH_EXPERIMENTS");
  const std::filesystem::path directory =
      named ? std::filesystem::path(named)
            : std::filesystem::path(SLOSH_SOURCE_DIR) / ".." / "shared" / "experiments";
  if (!std::filesystem::exists(directory / name)) return std::nullopt;
  return directory / name;
}

inline const std::string record_missing =
    " was not supplied: set SLOSH_EXPERIMENTS to the directory of published records";

}  // namespace slosh
