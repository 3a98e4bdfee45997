// A directory that is there with all its files or not at all.
#pragma once

#include <filesystem>
#include <functional>

namespace slosh {

// Passes an empty directory of a temporary name to `fill` and renames it to `directory` when that
// returns. Where it throws, nothing is left but directories above it that had to be made. Throws
// std::filesystem::filesystem_error where `directory` is a file or holds one already, and where it
// cannot be written.
void make_whole_directory(const std::filesystem::path& directory,
                          const std::function<void(const std::filesystem::path&)>& fill);

}  // namespace slosh
