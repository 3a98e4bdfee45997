// Opens the outputs of the tool. A regular file is replaced atomically: a reader sees the old
// content or the new one, never a part of it.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace slosh {

// What the new content survives. power_loss waits for the disk (fsync).
enum class Durability { process_crash, power_loss };

// Writes to a temporary file in the same directory (made if needed) and renames it. Follows
// symbolic links, which stay. Writes into a device or a pipe as it is. Throws OutputError
// (protected_inputs.hpp) where the file is an input of this process, and
// std::filesystem::filesystem_error; the temporary file is then removed and the old content
// unchanged.
void replace_file(const std::filesystem::path& file, std::string_view content,
                  Durability durability);

// Writes all of it. Throws std::filesystem::filesystem_error with the file's name.
void write_all(int descriptor, const std::filesystem::path& file, std::string_view content);

// Whether the file is a device or a pipe. Throws std::filesystem::filesystem_error for links that
// lead in a circle.
bool is_written_through(const std::filesystem::path& file);

// Returns where the links of a file lead, which need not be there. Throws as is_written_through().
std::filesystem::path linked_file(std::filesystem::path file);

// Makes a file or a directory of a temporary name beside the place and returns its path. `make`
// returns false where there is something of that name, which a killed process may have left: it
// stays, and another name is tried.
std::filesystem::path make_beside(const std::filesystem::path& place,
                                  const std::function<bool(const std::filesystem::path&)>& make);

// Makes a directory that is there with all its files or not at all.
// Passes an empty directory of a temporary name to `fill` and renames it to `directory` when that
// returns. Where it throws, nothing is left but directories above it that had to be made. Throws
// std::filesystem::filesystem_error where `directory` is a file or holds one already, and where it
// cannot be written.
void make_whole_directory(const std::filesystem::path& directory,
                          const std::function<void(const std::filesystem::path&)>& fill);

}  // namespace slosh
