// An exclusive lock on a file (flock(2)), which ends with the process that holds it.
#pragma once

#include <filesystem>
#include <functional>

namespace slosh {

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
