// The 128-bit XXH3 hash of bytes in 32 hexadecimal digits. It guards result files and names what
// they were made from. It detects accidents, not forgery.
#pragma once

#include <cstdint>
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

// The most that is read of a file [byte]: a comparison of 10,000,000 samples needs a fifth of it. A
// file of holes has any size.
inline constexpr std::uintmax_t largest_file = 1'000'000'000;

// The bytes of the file that lie on the disk, fewer than its size where it has holes. Throws as
// read_bytes() does.
std::uintmax_t stored_bytes(const std::filesystem::path& file);

// The content of a file. Throws std::filesystem::filesystem_error, with the file's name, where it
// cannot be read, is larger than that, or is no plain file (plain_file.hpp).
std::string read_bytes(const std::filesystem::path& file);

// The same of a file that the user names: it is then an input (protected_inputs.hpp).
std::string read_input(const std::filesystem::path& file);

}  // namespace slosh
