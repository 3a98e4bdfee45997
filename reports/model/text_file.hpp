// Whole text files, with errors that name the file.
#pragma once

#include <filesystem>
#include <string>

namespace slosh::reports {

// Both throw ReportError with the path and the system's reason.
std::string read_text(const std::filesystem::path& path);
void write_text(const std::filesystem::path& path, const std::string& text);

}  // namespace slosh::reports
