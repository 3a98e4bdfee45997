// The state from which an SPH run restarts (sph/restart/saved_state.hpp), as a sealed HDF5 file
// (sealed_file.hpp) with the attribute key and a group for each part of the state.
#pragma once

#include <filesystem>
#include <string>

#include "sph/restart/saved_state.hpp"

namespace slosh {

// Returns the file of a run's state in a directory.
std::filesystem::path state_file(const std::filesystem::path& directory,
                                 const std::string& run_name);

// Returns the file of the last good state of a run that failed.
std::filesystem::path last_good_state_file(const std::filesystem::path& directory,
                                           const std::string& run_name);

// `key` is the run's (run_key.hpp). Both throw ResultError; read_state() also where the state
// belongs to a run of another key.
void write_state(const sph::SavedState& state, const std::string& key,
                 const std::filesystem::path& file);
sph::SavedState read_state(const std::string& key, const std::filesystem::path& file);

}  // namespace slosh
