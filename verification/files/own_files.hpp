// What Slosh has made, and may therefore remove or replace without being asked. Each directory in
// which that matters has a list of it, the file ".slosh", with one name a line.
#pragma once

#include <filesystem>
#include <optional>

namespace slosh {

// Returns whether the list beside the path names it.
bool is_own(const std::filesystem::path& path);

// Puts the path on the list before it is made, and makes the directory that it lies in. Throws
// std::filesystem::filesystem_error where something is there that is not on the list, and where the
// list cannot be written.
void claim(const std::filesystem::path& path);

// Puts all that lies in a directory that Slosh has just made on the lists.
void claim_all_in(const std::filesystem::path& directory);

// Returns what lies in the directory, at any depth, and is not on the list beside it, if anything.
std::optional<std::filesystem::path> foreign_in(const std::filesystem::path& directory);

}  // namespace slosh
