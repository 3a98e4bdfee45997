// The project's documents, and what is found in them.
#pragma once

#include <filesystem>
#include <regex>
#include <string>
#include <vector>

namespace slosh::documents {

// README.md, CONTRIBUTING.md and the pages of docs/.
inline std::vector<std::filesystem::path> files(const std::filesystem::path& source) {
  std::vector<std::filesystem::path> files{source / "README.md", source / "CONTRIBUTING.md"};
  for (const auto& entry : std::filesystem::directory_iterator(source / "docs"))
    if (entry.path().extension() == ".md") files.push_back(entry.path());
  return files;
}

// The first group of each match.
inline std::vector<std::string> all_matches(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), expression), end; at != end; ++at)
    found.push_back((*at)[1]);
  return found;
}

}  // namespace slosh::documents
