// A file in memory with a path, for readers that take one: fuzzing through a disk would be slow.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

namespace slosh {

class MemoryFile {
 public:
  MemoryFile() : descriptor_(::memfd_create("fuzzed", MFD_CLOEXEC)) {
    if (descriptor_ < 0) throw std::system_error(errno, std::generic_category(), "memfd_create");
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { ::close(descriptor_); }

  void replace(std::string_view content) {
    const auto size = static_cast<ssize_t>(content.size());
    if (::ftruncate(descriptor_, 0) != 0 || ::pwrite(descriptor_, content.data(), size, 0) != size)
      throw std::system_error(errno, std::generic_category(), "a file in memory");
  }
  void replace(const std::uint8_t* bytes, std::size_t count) {
    replace(std::string_view(reinterpret_cast<const char*>(bytes), count));
  }

  std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

}  // namespace slosh
