// Replaces a file as a whole: whoever reads it meets the old content or the new one, never a part.
#pragma once

#include <filesystem>
#include <string_view>

namespace slosh {

enum class Durability { process_crash, power_loss };  // the latter waits for the disk (fsync)

// Writes to a temporary file in the same directory (made if need be) and renames it. Throws
// std::filesystem::filesystem_error; the temporary file is gone then and the old content is as it
// was.
void replace_file(const std::filesystem::path& file, std::string_view content,
                  Durability durability);

}  // namespace slosh
