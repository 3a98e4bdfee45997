// The one form in which a reference refuses an argument: what it is, what was given, what was
// expected.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string_view>

namespace slosh::reference {

// Throws std::invalid_argument unless `holds`, which the caller writes so that NaN does not hold.
template <class Value>
void require(bool holds, std::string_view where, std::string_view key, Value value,
             std::string_view expected) {
  if (!holds) {
    throw std::invalid_argument(
        fmt::format("{}: {} = {}, expected {}", where, key, value, expected));
  }
}

}  // namespace slosh::reference
