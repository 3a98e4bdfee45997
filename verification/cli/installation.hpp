// Where the tool's data lies, and how command lines name paths.
#pragma once

#include <filesystem>
#include <string>

namespace slosh {

struct Installation {
  std::filesystem::path executable, builds, source, cases, campaigns, baselines, openfoam_templates,
      build;
};

inline constexpr const char* store_variable = "SLOSH_STORE";

// Returns the directory of the results that campaigns share: SLOSH_STORE of the environment, or
// build/store.
std::filesystem::path usual_store(const Installation& installation);

// Returns where `show` and `explain` leave a page of this name. Throws CaseFileError where its
// directory is a link or a file.
std::filesystem::path shown_page(const Installation& installation, const std::string& name);

// Returns how a command line names the file: a shipped one by its name, any other by its path.
std::string name_or_path(const std::filesystem::path& file, const std::filesystem::path& shipped);

// Returns the absolute path without dots and links. An empty path stays empty.
std::filesystem::path whole(const std::filesystem::path& path);

// Returns the option by which a command finds the user's records; empty if no directory is named.
std::string experiments_option(const std::filesystem::path& experiments);

}  // namespace slosh
