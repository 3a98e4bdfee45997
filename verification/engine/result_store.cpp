#include "verification/engine/result_store.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

std::string question_of(const std::string& key) { return key.substr(0, key.find('-')); }
std::string answer_of(const std::string& key) { return key.substr(key.find('-') + 1); }

// Of the names that atomic_file.hpp writes under.
void remove_half_written(const fs::path& directory, const std::string& answer) {
  for (const auto& entry : fs::directory_iterator(directory)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("." + answer + ".") && name.ends_with(".partial")) fs::remove(entry);
  }
}

}  // namespace

fs::path ResultStore::file(const std::string& key, const char* extension) const {
  return root_ / question_of(key) / (answer_of(key) + extension);
}

std::optional<fs::path> ResultStore::newest_file(const std::string& key,
                                                 const char* extension) const {
  const fs::path own = file(key, extension);
  if (fs::exists(own)) return own;
  std::optional<fs::path> newest;
  if (!fs::is_directory(own.parent_path())) return newest;
  for (const auto& entry : fs::directory_iterator(own.parent_path())) {
    // "<answer>.h5", and none of the states that lie beside it in work directories.
    if (entry.path().extension() != extension || entry.path().stem().has_extension()) continue;
    if (!newest || fs::last_write_time(entry) > fs::last_write_time(*newest)) newest = entry;
  }
  return newest;
}

StoreLock::StoreLock(const ResultStore& store, const std::string& key)
    : lock_(store.file(key, ".lock")) {
  remove_half_written(store.file(key, "").parent_path(), answer_of(key));
}

}  // namespace slosh
