// What may be read as data: a regular file of a disk. A pipe, a socket or a device can keep a
// reader waiting for ever. The files of /proc and /sys are regular too, but tell of this process
// and this machine: a case that names /proc/self/environ would print the secrets of whoever runs
// it.
#pragma once

#include <linux/magic.h>
#include <sys/stat.h>
#include <sys/vfs.h>

#include <filesystem>

namespace slosh {

inline bool is_plain_file(const struct stat& status, const struct statfs& system) {
  return S_ISREG(status.st_mode) && system.f_type != PROC_SUPER_MAGIC &&
         system.f_type != SYSFS_MAGIC;
}

// Whether what was opened may be read as data.
inline bool is_plain_file(int descriptor) {
  struct stat status;
  struct statfs system;
  return ::fstat(descriptor, &status) == 0 && ::fstatfs(descriptor, &system) == 0 &&
         is_plain_file(status, system);
}

// The same of a name, links followed. Opens nothing.
inline bool is_plain_file(const std::filesystem::path& file) {
  struct stat status;
  struct statfs system;
  return ::stat(file.c_str(), &status) == 0 && ::statfs(file.c_str(), &system) == 0 &&
         is_plain_file(status, system);
}

}  // namespace slosh
