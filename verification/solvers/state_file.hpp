// What an SPH run goes on from (sph/saved_state.hpp), as a sealed HDF5 file (sealed_file.hpp): the
// attribute key, and a group for each part of the state under the part's own name.
#pragma once

#include <filesystem>
#include <string>

#include "sph/saved_state.hpp"

namespace slosh {

// The state of a run in a directory.
std::filesystem::path state_file(const std::filesystem::path& directory,
                                 const std::string& run_name);

// What a run that went wrong was at its last sample.
std::filesystem::path last_good_state_file(const std::filesystem::path& directory,
                                           const std::string& run_name);

// `key` of the run (run_key.hpp). Both throw ResultError; reading also where the state is of a run
// of another key.
void write_state(const sph::SavedState& state, const std::string& key,
                 const std::filesystem::path& file);
sph::SavedState read_state(const std::string& key, const std::filesystem::path& file);

}  // namespace slosh
