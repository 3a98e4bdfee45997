#include "verification/results/result_store.hpp"

#include <fmt/format.h>

#include <fstream>
#include <set>

#include "verification/files/content_hash.hpp"
#include "verification/files/own_files.hpp"
#include "verification/files/result_error.hpp"
#include "verification/files/sealed_file.hpp"
#include "verification/files/sealed_json.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

std::string question_of(const std::string& key) { return key.substr(0, key.find('-')); }
std::string answer_of(const std::string& key) { return key.substr(key.find('-') + 1); }

// Returns whether the file is what a killed process has left of a result: it has the name that
// atomic_file.hpp gives, and begins as files of the store do.
bool is_half_written(const fs::path& path, const std::string& answer) {
  const std::string name = path.filename().string();
  if (!name.starts_with("." + answer + ".") || !name.ends_with(".partial") ||
      !fs::is_regular_file(fs::symlink_status(path)))
    return false;
  std::string head(5, ' ');
  std::ifstream stream(path, std::ios::binary);
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(stream.gcount()));
  return head.empty() || head == "\x89HDF\r" || head == "{\n \"b";
}

void remove_half_written(const fs::path& directory, const std::string& answer) {
  for (const auto& entry : fs::directory_iterator(directory))
    if (is_half_written(entry.path(), answer)) fs::remove(entry);
}

constexpr const char* lock_extension = ".lock";
constexpr std::size_t digits_of_half = 32;

// Returns whether the name is a question or an answer, as content_hash() writes them.
bool is_half(const std::string& name) {
  return name.size() == digits_of_half &&
         name.find_first_not_of("0123456789abcdef") == std::string::npos;
}

// Returns the answer in "<answer>.h5" or, of a half-written file, in ".<answer>.h5.123.partial".
std::string answer_in(const std::string& file_name) {
  const std::size_t begin = file_name.starts_with(".") ? 1 : 0;
  return file_name.substr(begin, file_name.find('.', begin) - begin);
}

// Of what can be read: nothing of what lies deeper than a path reaches.
std::uintmax_t size_of(const fs::path& path) {
  std::error_code lost;
  const fs::file_status status = fs::symlink_status(path, lost);
  std::uintmax_t size = fs::is_regular_file(status) ? fs::file_size(path, lost) : 0;
  if (lost) return 0;
  if (fs::is_directory(status))
    for (fs::directory_iterator entry(path, lost), end; entry != end; entry.increment(lost))
      size += size_of(*entry);
  return size;
}

}  // namespace

fs::path ResultStore::file(const std::string& key, const char* extension) const {
  return root_ / question_of(key) / (answer_of(key) + extension);
}

fs::path ResultStore::file_without_links(const std::string& key, const char* extension) const {
  const fs::path own = file(key, extension), question = own.parent_path();
  const auto require_no_link = [](const fs::path& path) {
    if (fs::is_symlink(path))
      throw ResultError(path.string() +
                        ": is a link, expected a file or a directory of the store; remove it");
  };
  require_no_link(question);
  if (fs::is_directory(question))
    for (const fs::path& path : paths(key)) require_no_link(path);
  return own;
}

std::optional<fs::path> ResultStore::newest_file(const std::string& key,
                                                 const char* extension) const {
  const fs::path own = file(key, extension);
  if (fs::exists(own)) return own;
  std::optional<fs::path> newest;
  if (!fs::is_directory(own.parent_path())) return newest;
  for (const auto& entry : fs::directory_iterator(own.parent_path())) {
    // Takes "<answer>.h5", but none of the states in work directories.
    if (entry.path().extension() != extension || entry.path().stem().has_extension()) continue;
    if (!newest || fs::last_write_time(entry) > fs::last_write_time(*newest)) newest = entry;
  }
  return newest;
}

std::vector<std::string> ResultStore::keys() const {
  std::set<std::string> found;
  if (!fs::is_directory(root_)) return {};
  constexpr auto skip = fs::directory_options::skip_permission_denied;
  for (const auto& question : fs::directory_iterator(root_)) {
    const std::string name = question.path().filename().string();
    if (!is_half(name) || !question.is_directory()) continue;
    for (const auto& entry : fs::directory_iterator(question, skip)) {
      const std::string answer = answer_in(entry.path().filename().string());
      if (is_half(answer) && entry.path().filename() != answer + lock_extension)
        found.insert(fmt::format("{}-{}", name, answer));
    }
  }
  return {found.begin(), found.end()};
}

std::vector<fs::path> ResultStore::results() const {
  std::vector<fs::path> found;
  for (const std::string& key : keys())
    for (const char* extension : {".h5", ".json"})
      if (fs::path one = file(key, extension); fs::exists(one)) found.push_back(std::move(one));
  return found;
}

std::vector<fs::path> ResultStore::paths(const std::string& key) const {
  std::vector<fs::path> found;
  const std::string answer = answer_of(key);
  for (const auto& entry : fs::directory_iterator(file(key, "").parent_path())) {
    const std::string name = entry.path().filename().string();
    if (answer_in(name) == answer && name != answer + lock_extension) found.push_back(entry.path());
  }
  return found;
}

std::uintmax_t ResultStore::size(const std::string& key) const {
  std::uintmax_t size = 0;
  for (const fs::path& path : paths(key)) size += size_of(path);
  return size;
}

bool ResultStore::has_made(const std::string& key, const fs::path& path) const try {
  const std::string name = path.filename().string(), answer = answer_of(key);
  const auto is = [&](const char* extension) { return name == answer + extension; };
  const fs::file_status status = fs::symlink_status(path);
  if (fs::is_directory(status)) return !foreign_at(path);
  if (!fs::is_regular_file(status)) return false;
  if (name.starts_with(".")) return is_half_written(path, answer);
  const std::string bytes = read_bytes(path);
  const bool holds_key = bytes.find(key) != bytes.npos;
  return (is(".h5") && holds_key && is_sealed(bytes)) ||
         (((is(".json") && holds_key) || is(".timings.json") || is(".failure.json")) &&
          is_sealed_json(bytes));
} catch (const fs::filesystem_error&) {  // it cannot be read
  return false;
}

StoreContents ResultStore::contents(const std::string& key) const {
  StoreContents contents;
  for (const fs::path& path : paths(key)) {
    const bool made = has_made(key, path);
    (made ? contents.made : contents.foreign).push_back(path);
    if (made) contents.size += size_of(path);
  }
  return contents;
}

bool ResultStore::remove(const std::string& key) const {
  struct InUse {};
  const StoreContents found =
      contents(key);  // before a lock is there by which more would be its own
  if (found.made.empty()) return true;
  try {
    const FileLock lock(file(key, lock_extension), [] { throw InUse(); });
    for (const fs::path& path : found.made) fs::remove_all(path);
    return true;
  } catch (const InUse&) {
    return false;
  }
}

void require_key_of_place(const std::string& key, const fs::path& file) {
  const std::string named = file.parent_path().filename().string() + "-" + file.stem().string();
  if (key != named)
    throw ResultError(
        fmt::format("{}: holds the result of the key {}, expected that of its place, {}",
                    file.string(), key, named));
}

StoreLock::StoreLock(const ResultStore& store, const std::string& key,
                     const std::function<void()>& waiting)
    : lock_(store.file_without_links(key, lock_extension), waiting) {
  remove_half_written(store.file(key, "").parent_path(), answer_of(key));
}

}  // namespace slosh
