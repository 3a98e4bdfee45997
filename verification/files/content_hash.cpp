#include "verification/files/content_hash.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>

namespace slosh {

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

std::string read_bytes(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const bool is_directory = std::filesystem::is_directory(file);
  if (!stream || is_directory) {
    const auto reason = is_directory ? std::make_error_code(std::errc::is_a_directory)
                                     : std::error_code(errno, std::generic_category());
    throw std::filesystem::filesystem_error("cannot read", file, reason);
  }
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  return std::move(bytes).str();
}

}  // namespace slosh
