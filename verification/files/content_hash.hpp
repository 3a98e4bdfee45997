// The 128-bit XXH3 hash of bytes in 32 hexadecimal digits. It guards result files and names what
// they were made from. It detects accidents, not forgery.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace slosh {

class ContentHash {
 public:
  ContentHash();
  ~ContentHash();
  void add(std::string_view bytes);
  // Adds the content of a file. Throws std::filesystem::filesystem_error where it cannot be read.
  void add_file(const std::filesystem::path& file);
  std::string digits() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

std::string content_hash(std::string_view bytes);

// The content of a file. Throws std::filesystem::filesystem_error where it cannot be read, and
// where it is no plain file (plain_file.hpp).
std::string read_bytes(const std::filesystem::path& file);

}  // namespace slosh
