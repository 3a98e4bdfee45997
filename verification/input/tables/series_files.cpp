#include "verification/input/tables/series_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "verification/input/tables/table_reader.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

std::map<double, fs::path> time_folders(const fs::path& directory) {
  std::map<double, fs::path> folders;
  std::error_code unreadable;
  for (const auto& entry : fs::directory_iterator(directory, unreadable))
    if (const auto time = number_in(entry.path().filename().string());
        time && std::isfinite(*time) && entry.is_directory())
      folders.emplace(*time, entry.path());
  return folders;
}

// The file that a part is of, with the time at which the part begins: "force.dat" and 5 of
// "force_5.dat".
std::optional<std::pair<fs::path, double>> whole_of(const fs::path& part) {
  const std::string stem = part.stem().string();
  const std::size_t bar = stem.rfind('_');
  if (bar == stem.npos) return std::nullopt;
  const fs::path whole = part.parent_path() / (stem.substr(0, bar) + part.extension().string());
  const auto time = number_in(stem.substr(bar + 1));
  if (!time || !std::isfinite(*time) || !fs::is_regular_file(whole)) return std::nullopt;
  return std::pair{whole, *time};
}

// The parts by the file that they are of.
std::map<std::string, std::vector<fs::path>> parts_in(const fs::path& directory) {
  std::map<std::string, std::vector<fs::path>> parts;
  for (const auto& [time, folder] : time_folders(directory)) {
    std::map<fs::path, std::map<double, fs::path>> later;
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (!entry.is_regular_file()) continue;
      if (const auto whole = whole_of(entry.path()))
        later[whole->first][whole->second] = entry.path();
      else
        parts[entry.path().filename().string()].push_back(entry.path());
    }
    for (const auto& [whole, files] : later)
      for (const auto& [begin, file] : files) parts[whole.filename().string()].push_back(file);
  }
  return parts;
}

}  // namespace

std::vector<fs::path> series_files(const fs::path& file) {
  std::error_code lost;  // as where links lead in a circle
  if (fs::is_regular_file(file, lost)) return {file};
  const fs::path directory = file.has_filename() ? file : file.parent_path();
  if (!fs::is_directory(directory, lost)) {
    const auto parts = parts_in(directory.parent_path());
    const auto found = parts.find(directory.filename().string());
    return found == parts.end() ? std::vector<fs::path>() : found->second;
  }
  const auto parts = parts_in(directory);
  if (parts.empty()) return {};
  if (parts.size() == 1) return parts.begin()->second;
  std::vector<std::string> names;
  for (const auto& [name, files] : parts) names.push_back((directory / name).string());
  throw CaseFileError(fmt::format("file = {}: expected one of its time folders' files, {}",
                                  file.string(), fmt::join(names, " or ")));
}

std::string no_file_at(const fs::path& path) {
  std::error_code lost;
  return fs::is_directory(path, lost) ? path.string() + " is a directory"
                                      : "there is no " + path.string();
}

}  // namespace slosh
