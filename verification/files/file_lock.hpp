// An exclusive lock on a file (flock(2)), which ends with the process that holds it.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace slosh {

// What a start says on standard error once it waits: "another start works in DIR; waiting for it".
// The campaign that has started it finds these words in its log.
inline constexpr const char* waiting_words = "; waiting for it";
// Says so when it is first called, of another start that `does` this.
std::function<void()> telling_once(const std::string& does);

class FileLock {
 public:
  // Makes the file, for this user alone, and its directory if needed, and waits for the lock.
  // Meanwhile it calls `waiting` about ten times a second, which may throw. Throws
  // std::filesystem::filesystem_error, also where the file is a link or no regular file.
  explicit FileLock(const std::filesystem::path& file, const std::function<void()>& waiting = {});
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;
  ~FileLock();

 private:
  int descriptor_;
};

}  // namespace slosh
