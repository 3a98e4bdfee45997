// The first half of a key, which is the question that a result answers.
#pragma once

#include <string_view>

namespace slosh {

// Whether two keys have the same question, be it answered by different builds or versions.
inline bool asks_the_same(std::string_view key, std::string_view other) {
  return key.substr(0, key.find('-')) == other.substr(0, other.find('-'));
}

}  // namespace slosh
