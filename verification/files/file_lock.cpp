#include "verification/files/file_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <iostream>
#include <system_error>
#include <thread>
#include <utility>

namespace slosh {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds lock_interval{100};

fs::filesystem_error failure(const fs::path& file) {
  return fs::filesystem_error("cannot lock", file, std::error_code(errno, std::generic_category()));
}

void require_regular(int descriptor, const fs::path& file) {
  struct stat status;
  if (::fstat(descriptor, &status) != 0) throw failure(file);
  if (S_ISREG(status.st_mode)) return;
  errno = EINVAL;
  throw failure(file);
}

void wait_for(int descriptor, const fs::path& file, const std::function<void()>& waiting) {
  while (::flock(descriptor, waiting ? LOCK_EX | LOCK_NB : LOCK_EX) != 0) {
    if (errno == EINTR) continue;
    if (errno != EWOULDBLOCK) throw failure(file);
    waiting();
    std::this_thread::sleep_for(lock_interval);
  }
}

}  // namespace

std::function<void()> telling_once(const std::string& does) {
  return [does, told = false]() mutable {
    if (!std::exchange(told, true)) std::cerr << "another start " + does + waiting_words + "\n";
  };
}

FileLock::FileLock(const fs::path& file, const std::function<void()>& waiting) {
  if (file.has_parent_path()) fs::create_directories(file.parent_path());
  descriptor_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0600);
  if (descriptor_ < 0) throw failure(file);
  try {
    require_regular(descriptor_, file);
    wait_for(descriptor_, file, waiting);
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

FileLock::~FileLock() { ::close(descriptor_); }

}  // namespace slosh
