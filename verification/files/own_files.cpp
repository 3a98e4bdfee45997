#include "verification/files/own_files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <exception>
#include <map>
#include <mutex>
#include <set>
#include <sstream>
#include <system_error>
#include <utility>

#include "verification/files/atomic_file.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/files/protected_inputs.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

constexpr const char* list_name = ".slosh";
constexpr const char* refusal =
    "will not replace what Slosh has not left so, by its list .slosh there; name another place, or "
    "remove this file, as after a change of Slosh's version";

[[noreturn]] void refuse(const std::string& action, const fs::path& path, int reason) {
  throw fs::filesystem_error(action, path, std::error_code(reason, std::generic_category()));
}

std::string hash_of(std::string_view content, const std::string& command) {
  ContentHash hash;
  hash.add(command);
  hash.add(content);
  return hash.digits();
}

std::string identity_of(const fs::path& path, const std::string& command) {
  const fs::file_status status = fs::symlink_status(path);
  if (fs::is_symlink(status)) return hash_of(fs::read_symlink(path).native(), command);
  if (!fs::is_regular_file(status)) return "no_file";
  if (fs::file_size(path) > largest_file) return fmt::format("{}_bytes", fs::file_size(path));
  return hash_of(read_bytes(path), command);
}

// The identity of what a program has left, which may be much: its size and when it was written.
std::string stamp_of(const fs::path& path) {
  if (!fs::is_regular_file(fs::symlink_status(path))) return identity_of(path, "");
  return fmt::format("{}_bytes_at_{}", fs::file_size(path),
                     fs::last_write_time(path).time_since_epoch().count());
}

// The identities that the list of a directory gives to each name.
using Identities = std::map<std::string, std::set<std::string>>;

Identities listed_in(const fs::path& directory) try {
  if (!fs::is_regular_file(fs::symlink_status(directory / list_name))) return {};
  Identities listed;
  std::istringstream lines(read_bytes(directory / list_name));
  for (std::string identity, name; lines >> identity && std::getline(lines.ignore(), name);)
    listed[name].insert(identity);
  return listed;
} catch (const fs::filesystem_error&) {
  return {};
}

void append(const std::string& lines, const fs::path& directory) {
  const fs::path list = directory / list_name;
  const int descriptor = ::open(
      list.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
  if (descriptor < 0) refuse("cannot write", list, errno);
  const bool is_written =
      ::write(descriptor, lines.data(), lines.size()) == static_cast<ssize_t>(lines.size());
  const int reason = errno;
  ::close(descriptor);
  if (!is_written) refuse("cannot write", list, reason);
}

// A name of two lines cannot stand in a list, and stays foreign.
std::string line_of(const std::string& identity, const fs::path& path) {
  const std::string name = path.filename().string();
  // A line that a full disk has cut ends where the next begins.
  return name.find('\n') == name.npos ? "\n" + identity + " " + name + "\n" : "";
}

void add(const std::string& identity, const fs::path& path) {
  const fs::path directory = path.parent_path();
  fs::create_directories(directory);
  if (!listed_in(directory)[path.filename().string()].contains(identity))
    append(line_of(identity, path), directory);
}

std::optional<fs::path> foreign_at(const fs::path& path, const Identities& listed,
                                   const std::string& command) {
  const fs::file_status status = fs::symlink_status(path);
  const auto found = listed.find(path.filename().string());
  const std::set<std::string> known =
      found == listed.end() ? std::set<std::string>() : found->second;
  if (!fs::exists(status)) return std::nullopt;
  if (fs::is_directory(status)) try {
      const Identities inside = listed_in(path);
      for (const auto& entry : fs::directory_iterator(path))
        if (auto foreign = foreign_at(entry.path(), inside, "")) return foreign;
      return std::nullopt;
    } catch (const fs::filesystem_error&) {  // it cannot be read, as below the longest path
      return path;
    }
  const bool is_lock = path.filename() == "lock" && fs::is_regular_file(status) &&
                       fs::file_size(path) == 0;  // file_lock.hpp
  const bool is_list = fs::is_regular_file(status) && path.filename() == list_name;
  if (is_list || is_lock ||
      (!known.empty() &&
       (known.contains(stamp_of(path)) || known.contains(identity_of(path, command)))))
    return std::nullopt;
  return path;
}

struct Found {
  fs::path place;  // absolute, without dots
  std::optional<fs::path> foreign;
};

Found found_at(const fs::path& path, const std::string& command) {
  fs::path place = fs::absolute(path).lexically_normal();
  if (!place.has_filename()) place = place.parent_path();
  auto foreign = foreign_at(place, listed_in(place.parent_path()), command);
  // A link of Slosh's is itself replaced, and not what it leads to.
  const bool is_own_link = !foreign && fs::is_symlink(fs::symlink_status(place));
  if (!is_own_link) require_no_input(path);
  for (fs::path at = place.parent_path(); at.has_relative_path(); at = at.parent_path())
    if (fs::is_symlink(fs::symlink_status(at)))
      refuse("will not write through a link; expected a directory", at, ELOOP);
  return {place, foreign};
}

fs::path own_place(const fs::path& path, const std::string& command) {
  const Found found = found_at(path, command);
  if (found.foreign) refuse(refusal, *found.foreign, EEXIST);
  return found.place;
}

// Links and devices are not set aside: whoever laid them there expects them to stay.
void require_movable(const Found& found) {
  const fs::file_status status = fs::symlink_status(found.place);
  if (found.foreign && !fs::is_regular_file(status) && !fs::is_directory(status))
    refuse(refusal, *found.foreign, EEXIST);
}

class SetAside {
 public:
  void add(const fs::path& place, const std::string& what) {
    const std::lock_guard lock(mutex_);
    told_.push_back(place.string() + " is not as Slosh has left it; " + what);
  }
  std::vector<std::string> told() const {
    const std::lock_guard lock(mutex_);
    return told_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<std::string> told_;
};

SetAside& set_aside() {
  static SetAside all;
  return all;
}

// Renames to the first name that is free.
void move_aside(const fs::path& place) {
  for (int number = 1;; ++number) {
    const fs::path kept = place.native() + fmt::format(".kept-{}", number);
    if (fs::exists(fs::symlink_status(kept))) continue;
    if (renameat2(AT_FDCWD, place.c_str(), AT_FDCWD, kept.c_str(), RENAME_NOREPLACE) != 0) {
      if (errno == EEXIST) continue;
      // Some network file systems know no such flag.
      if (errno != EINVAL && errno != ENOSYS) refuse("cannot set aside", place, errno);
      fs::rename(place, kept);
    }
    return set_aside().add(place, "it is kept as " + kept.filename().string());
  }
}

fs::path free_place(const Found& found) {
  require_movable(found);
  if (found.foreign) move_aside(found.place);
  return found.place;
}

// Returns the standard stream that writes to this very file, or -1.
int stream_to(const fs::path& file) {
  struct stat there, of_stream;
  if (::stat(file.c_str(), &there) != 0 || !S_ISREG(there.st_mode)) return -1;
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
    if (::fstat(stream, &of_stream) == 0 && of_stream.st_dev == there.st_dev &&
        of_stream.st_ino == there.st_ino)
      return stream;
  return -1;
}

// Where the links of a file that the user names lead.
fs::path named_place(const fs::path& file) {
  require_no_input(file);
  const fs::path place = linked_file(fs::absolute(file));
  return fs::weakly_canonical(place.parent_path()) / place.filename();
}

void replace_listed(const fs::path& place, std::string_view content, const std::string& command) {
  add(hash_of(content, command), place);
  replace_file(place, content, Durability::process_crash);
}

}  // namespace

std::optional<fs::path> foreign_at(const fs::path& path) {
  return foreign_at(path, listed_in(path.parent_path()), "");
}

void require_own(const fs::path& path) { own_place(path, ""); }

void require_room(const fs::path& path) { require_movable(found_at(path, "")); }

void make_room(const fs::path& path) { free_place(found_at(path, "")); }

fs::path make_own_directory(const fs::path& named, const std::vector<std::string>& beside) {
  constexpr int most = 1000;
  for (int number = 1; number <= most; ++number) {
    const fs::path place = named.native() + (number == 1 ? "" : fmt::format("-{}", number));
    try {
      for (const std::string& ending : beside) require_own(place.native() + ending);
      require_own(place);
      for (const std::string& ending : beside) fs::remove(place.native() + ending);
      fs::remove_all(place);
    } catch (const std::exception&) {  // it is a user's, or it cannot be read
      continue;
    }
    fs::create_directories(place.parent_path());
    if (::mkdir(place.c_str(), 0777) != 0) {
      if (errno == EEXIST) continue;
      refuse("cannot make the directory", place, errno);
    }
    if (number > 1) set_aside().add(named, "the program works in " + place.filename().string());
    return place;
  }
  refuse("cannot make the directory, nor one of a thousand names like it", named, EEXIST);
}

std::vector<std::string> told_of_set_aside() { return set_aside().told(); }

void replace_own(const fs::path& file, std::string_view content) {
  const Found found = found_at(file, "");
  // What lost its list alone is Slosh's again.
  const bool is_same = found.foreign && identity_of(found.place, "") == hash_of(content, "");
  replace_listed(is_same ? found.place : free_place(found), content, "");
}

void replace_named(const fs::path& file, std::string_view content, const char* command) {
  if (const int stream = stream_to(file); stream >= 0) return write_all(stream, file, content);
  if (is_written_through(file)) return replace_file(file, content, Durability::process_crash);
  replace_listed(own_place(named_place(file), command), content, command);
}

void link_own(const fs::path& target, const fs::path& link) {
  const fs::path place = free_place(found_at(link, ""));
  add(hash_of(target.native(), ""), place);
  const fs::path next = make_beside(place, [&](const fs::path& one) {
    std::error_code taken;
    fs::create_symlink(target, one, taken);
    if (taken && taken != std::errc::file_exists) refuse("cannot make a link", one, taken.value());
    return !taken;
  });
  fs::rename(next, place);
}

namespace {

void list_all_in(const fs::path& directory) {
  std::string lines;
  for (const auto& entry : fs::directory_iterator(directory)) {
    if (fs::is_directory(entry.symlink_status()))
      list_all_in(entry.path());
    else if (entry.path().filename() != list_name)
      lines += line_of(stamp_of(entry.path()), entry.path());
  }
  append(lines, directory);
}

}  // namespace

OpenOutputs::OpenOutputs(std::vector<fs::path> paths) : paths_(std::move(paths)) {
  for (fs::path& path : paths_) path = free_place(found_at(path, ""));
  for (const fs::path& path : paths_) fs::create_directories(path.parent_path());
}

OpenOutputs::OpenOutputs(const fs::path& file, std::string command) : command_(std::move(command)) {
  if (!is_written_through(file)) paths_ = {own_place(named_place(file), command_)};
}

void OpenOutputs::make_room() const {
  for (const fs::path& path : paths_) free_place(found_at(path, command_));
}

OpenOutputs::~OpenOutputs() {
  // A command that has failed has left nothing.
  if (!command_.empty() && std::uncaught_exceptions() > 0) return;
  for (const fs::path& path : paths_) try {
      const fs::file_status status = fs::symlink_status(path);
      if (fs::is_directory(status)) list_all_in(path);
      if (fs::is_regular_file(status)) add(identity_of(path, command_), path);
    } catch (const std::exception&) {  // it is foreign
    }
}

}  // namespace slosh
