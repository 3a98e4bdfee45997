#include "verification/files/content_hash.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <xxhash.h>

#include <algorithm>
#include <cerrno>
#include <new>
#include <system_error>

#include "verification/files/foreign/plain_file.hpp"
#include "verification/files/protected_inputs.hpp"

namespace slosh {
namespace {

struct OpenedFile {
  explicit OpenedFile(int descriptor) : id(descriptor) {}
  OpenedFile(const OpenedFile&) = delete;
  OpenedFile& operator=(const OpenedFile&) = delete;
  ~OpenedFile() {
    if (id >= 0) ::close(id);
  }
  const int id;
};

}  // namespace

// XXH3's state needs 64-byte alignment, which its own allocator provides.
struct ContentHash::State {
  XXH3_state_t* xxh = XXH3_createState();
  ~State() { XXH3_freeState(xxh); }
};

ContentHash::ContentHash() : state_(std::make_unique<State>()) { XXH3_128bits_reset(state_->xxh); }
ContentHash::~ContentHash() = default;

void ContentHash::add(std::string_view bytes) {
  XXH3_128bits_update(state_->xxh, bytes.data(), bytes.size());
}

void ContentHash::add_file(const std::filesystem::path& file) { add(read_bytes(file)); }

std::string ContentHash::digits() const {
  const XXH128_hash_t hash = XXH3_128bits_digest(state_->xxh);
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

std::string content_hash(std::string_view bytes) {
  ContentHash hash;
  hash.add(bytes);
  return hash.digits();
}

std::uintmax_t stored_bytes(const std::filesystem::path& file) {
  struct stat status;
  const bool is_there = ::stat(file.c_str(), &status) == 0;
  const auto size = is_there ? static_cast<std::uintmax_t>(status.st_size) : 0;
  if (is_there && size <= largest_file)
    return std::min(size, static_cast<std::uintmax_t>(status.st_blocks) * 512);
  throw std::filesystem::filesystem_error(
      is_there ? fmt::format("cannot read {} bytes, expected at most {}", size, largest_file)
               : "cannot read",
      file, std::make_error_code(is_there ? std::errc::file_too_large : std::errc(errno)));
}

std::string read_bytes(const std::filesystem::path& file) try {
  const auto fail = [&](const std::string& action, std::errc reason) {
    throw std::filesystem::filesystem_error(action, file, std::make_error_code(reason));
  };
  const OpenedFile opened(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
  if (opened.id < 0) fail("cannot read", std::errc(errno));
  if (std::filesystem::is_directory(file)) fail("cannot read", std::errc::is_a_directory);
  if (!is_plain_file(opened.id))
    fail("cannot read what is no file of a disk", std::errc::invalid_argument);
  std::string bytes;
  bytes.reserve(stored_bytes(file));
  char part[1 << 16];
  for (ssize_t count; (count = ::read(opened.id, part, sizeof part)) != 0;) {
    if (count < 0 && errno != EINTR) fail("cannot read", std::errc(errno));
    if (count > 0) bytes.append(part, static_cast<std::size_t>(count));
    if (bytes.size() > largest_file)
      fail("cannot read a file that grows", std::errc::file_too_large);
  }
  return bytes;
} catch (const std::bad_alloc&) {
  throw std::filesystem::filesystem_error("cannot read", file,
                                          std::make_error_code(std::errc::not_enough_memory));
}

std::string read_input(const std::filesystem::path& file) {
  std::string bytes = read_bytes(file);
  protect_input(file);
  return bytes;
}

}  // namespace slosh
