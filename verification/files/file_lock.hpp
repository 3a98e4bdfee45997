// Holds a file for this process alone (flock(2)): a process that dies leaves it free.
#pragma once

#include <filesystem>
#include <functional>

namespace slosh {

class FileLock {
 public:
  // Makes the file and its directory if need be, and waits for whoever holds it; `waiting` is
  // called about ten times a second meanwhile, and may throw. Throws
  // std::filesystem::filesystem_error.
  explicit FileLock(const std::filesystem::path& file, const std::function<void()>& waiting = {});
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;
  ~FileLock();

 private:
  int descriptor_;
};

}  // namespace slosh
