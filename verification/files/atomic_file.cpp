#include "verification/files/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace slosh {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const char* action, const fs::path& file) {
  throw fs::filesystem_error(action, file, std::error_code(errno, std::generic_category()));
}

class Descriptor {
 public:
  Descriptor(const fs::path& file, int flags) : id_(::open(file.c_str(), flags | O_CLOEXEC, 0666)) {
    if (id_ < 0) fail("cannot open", file);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (id_ >= 0) ::close(id_);
  }
  operator int() const { return id_; }

  // A network file system may report a failed write only at the close.
  void close(const fs::path& file) {
    if (::close(std::exchange(id_, -1)) != 0) fail("cannot write", file);
  }

 private:
  int id_;
};

void write_all(const fs::path& file, std::string_view content, Durability durability) {
  Descriptor descriptor(file, O_WRONLY | O_CREAT | O_TRUNC);
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("cannot write", file);
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  if (durability == Durability::power_loss && ::fsync(descriptor) != 0) fail("cannot write", file);
  descriptor.close(file);
}

}  // namespace

void replace_file(const fs::path& file, std::string_view content, Durability durability) {
  const fs::path directory = fs::absolute(file).parent_path();
  fs::create_directories(directory);
  const fs::path temporary =
      directory / fmt::format(".{}.{}.partial", file.filename().string(), ::getpid());
  try {
    write_all(temporary, content, durability);
    fs::rename(temporary, file);
  } catch (...) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw;
  }
  // The new name reaches the disk with the directory.
  if (durability == Durability::power_loss) ::fsync(Descriptor(directory, O_RDONLY | O_DIRECTORY));
}

}  // namespace slosh
