#include "verification/engine/file_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace slosh {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& file) {
  throw fs::filesystem_error("cannot lock", file, std::error_code(errno, std::generic_category()));
}

}  // namespace

FileLock::FileLock(const fs::path& file, const std::function<void()>& waiting) {
  if (file.has_parent_path()) fs::create_directories(file.parent_path());
  descriptor_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail(file);
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
  if (errno == EWOULDBLOCK && waiting) waiting();
  while (::flock(descriptor_, LOCK_EX) != 0) {
    if (errno == EINTR) continue;
    ::close(descriptor_);
    fail(file);
  }
}

FileLock::~FileLock() { ::close(descriptor_); }

}  // namespace slosh
