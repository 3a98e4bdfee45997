#include "verification/files/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "verification/files/protected_inputs.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const char* action, const fs::path& file) {
  throw fs::filesystem_error(action, file, std::error_code(errno, std::generic_category()));
}

class Descriptor {
 public:
  explicit Descriptor(int id) : id_(id) {}
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

// A device or a pipe has no content to keep. A pipe that nobody reads is an error and no wait.
void write_through(const fs::path& file, std::string_view content) {
  Descriptor descriptor(file, O_WRONLY | O_NONBLOCK);
  ::fcntl(descriptor, F_SETFL, O_WRONLY);  // from here it waits for the reader
  write_all(descriptor, file, content);
  descriptor.close(file);
}

void write_new(int opened, const fs::path& file, std::string_view content, Durability durability) {
  Descriptor descriptor(opened);
  write_all(descriptor, file, content);
  if (durability == Durability::power_loss && ::fsync(descriptor) != 0) fail("cannot write", file);
  descriptor.close(file);
}

void require_free(const fs::path& directory) {
  if (!fs::exists(fs::symlink_status(directory))) return;
  if (!fs::is_directory(directory) || !fs::is_empty(directory))
    throw fs::filesystem_error("expected a directory that is not there yet, or an empty one",
                               directory, std::make_error_code(std::errc::file_exists));
}

}  // namespace

void write_all(int descriptor, const fs::path& file, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("cannot write", file);
    content.remove_prefix(static_cast<std::size_t>(written));
  }
}

bool is_written_through(const fs::path& file) {
  return fs::exists(file) && !fs::is_regular_file(file);
}

fs::path linked_file(fs::path file) {
  (void)fs::exists(file);  // throws for links that lead in a circle
  while (fs::is_symlink(file)) file = file.parent_path() / fs::read_symlink(file);
  return file;
}

fs::path make_beside(const fs::path& place, const std::function<bool(const fs::path&)>& make) {
  for (int attempt = 0;; ++attempt) {
    fs::path temporary =
        place.parent_path() / fmt::format(".{}.{}{}.partial", place.filename().string(), ::getpid(),
                                          attempt == 0 ? "" : fmt::format("-{}", attempt));
    if (make(temporary)) return temporary;
  }
}

void replace_file(const fs::path& file, std::string_view content, Durability durability) {
  require_no_input(file);
  if (is_written_through(file)) return write_through(file, content);
  const fs::path place = linked_file(fs::absolute(file)), directory = place.parent_path();
  fs::create_directories(directory);
  int opened = -1;
  const fs::path temporary = make_beside(place, [&](const fs::path& one) {
    opened = ::open(one.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (opened < 0 && errno != EEXIST) fail("cannot write", one);
    return opened >= 0;
  });
  try {
    write_new(opened, temporary, content, durability);
    fs::rename(temporary, place);
  } catch (...) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw;
  }
  // The new name reaches the disk with the directory.
  if (durability == Durability::power_loss) ::fsync(Descriptor(directory, O_RDONLY | O_DIRECTORY));
}

void make_whole_directory(const fs::path& directory,
                          const std::function<void(const fs::path&)>& fill) {
  const fs::path named = fs::weakly_canonical(fs::absolute(directory));
  const fs::path place = named.has_filename() ? named : named.parent_path();  // without a last "/"
  require_free(place);
  fs::create_directories(place.parent_path());
  const fs::path temporary =
      make_beside(place, [](const fs::path& one) { return fs::create_directory(one); });
  try {
    fill(temporary);
    fs::rename(temporary, place);  // an empty directory of this name gives way
  } catch (...) {
    std::error_code ignored;
    fs::remove_all(temporary, ignored);
    throw;
  }
}

}  // namespace slosh
