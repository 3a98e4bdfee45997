// Choices that the bytes of an input make: numbers and texts, in order, and zeros or nothing once
// the bytes are used up.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace slosh {

class ByteChoices {
 public:
  // The bytes must outlive the choices.
  ByteChoices(const std::uint8_t* bytes, std::size_t count) : next_(bytes), end_(bytes + count) {}

  std::size_t remaining() const { return static_cast<std::size_t>(end_ - next_); }

  bool flag() { return number(1) != 0; }

  // A number from 0 to `most`, from as few bytes as can hold it.
  std::uint64_t number(std::uint64_t most) {
    std::uint64_t value = 0;
    for (std::uint64_t left = most; left > 0 && next_ != end_; left >>= 8)
      value = value << 8 | *next_++;
    return most == UINT64_MAX ? value : value % (most + 1);
  }

  // Up to `most` bytes, as many as there are.
  std::vector<std::uint8_t> bytes(std::size_t most) {
    const std::uint8_t* begin = next_;
    next_ += std::min(most, remaining());
    return {begin, next_};
  }

  // Up to `longest` bytes.
  std::string text(std::size_t longest) {
    const std::vector<std::uint8_t> taken = bytes(number(longest));
    return {taken.begin(), taken.end()};
  }

 private:
  const std::uint8_t *next_, *end_;
};

}  // namespace slosh
