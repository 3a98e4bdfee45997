// Opens the outputs of the tool. A regular file is replaced atomically: a reader sees the old
// content or the new one, never a part of it.
#pragma once

#include <filesystem>
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

}  // namespace slosh
