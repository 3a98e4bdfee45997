// Paths as commands are given them, and as a command that repeats another one names them.
#pragma once

#include <filesystem>
#include <string>

namespace slosh {

// How a command line names the file: a shipped one by its name, any other by its path.
std::string name_or_path(const std::filesystem::path& file, const std::filesystem::path& shipped);

// Absolute and without dots; an empty path stays empty.
std::filesystem::path whole(const std::filesystem::path& path);

// What a command needs to find the user's records again, or nothing.
std::string experiments_option(const std::filesystem::path& experiments);

}  // namespace slosh
