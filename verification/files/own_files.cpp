#include "verification/files/own_files.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <set>
#include <sstream>
#include <string>
#include <system_error>

#include "verification/files/content_hash.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

constexpr const char* list_name = ".slosh";

std::set<std::string> names_in(const fs::path& directory) try {
  std::istringstream list(read_bytes(directory / list_name));
  std::set<std::string> names{list_name};
  for (std::string name; std::getline(list, name);) names.insert(name);
  return names;
} catch (const fs::filesystem_error&) {
  return {};
}

[[noreturn]] void refuse(const char* action, const fs::path& path, int reason) {
  throw fs::filesystem_error(action, path, std::error_code(reason, std::generic_category()));
}

void append(const std::string& lines, const fs::path& list) {
  const int descriptor =
      ::open(list.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | O_NOFOLLOW, 0666);
  if (descriptor < 0) refuse("cannot write", list, errno);
  const bool is_written =
      ::write(descriptor, lines.data(), lines.size()) == static_cast<ssize_t>(lines.size());
  const int reason = errno;
  ::close(descriptor);
  if (!is_written) refuse("cannot write", list, reason);
}

}  // namespace

bool is_own(const fs::path& path) {
  return names_in(path.parent_path()).contains(path.filename().string());
}

void claim(const fs::path& path) {
  const fs::path place = fs::absolute(path);
  if (is_own(place)) return;
  if (fs::exists(fs::symlink_status(place)))
    refuse("will not replace what Slosh has not made; expected another name or no such file", path,
           EEXIST);
  fs::create_directories(place.parent_path());
  append(place.filename().string() + "\n", place.parent_path() / list_name);
}

void claim_all_in(const fs::path& directory) {
  std::string names;
  for (const auto& entry : fs::directory_iterator(directory)) {
    names += entry.path().filename().string() + "\n";
    if (entry.is_directory()) claim_all_in(entry.path());
  }
  append(names, directory / list_name);
}

std::optional<fs::path> foreign_in(const fs::path& directory) {
  const std::set<std::string> own = names_in(directory);
  for (const auto& entry : fs::directory_iterator(directory)) {
    if (!own.contains(entry.path().filename().string())) return entry.path();
    if (fs::is_directory(entry.symlink_status()))
      if (auto foreign = foreign_in(entry.path())) return foreign;
  }
  return std::nullopt;
}

}  // namespace slosh
