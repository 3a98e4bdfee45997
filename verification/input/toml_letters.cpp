#include "verification/input/toml_letters.hpp"

#include <algorithm>
#include <string>

namespace slosh {
namespace {

// Returns the position after the string that opens at `begin`: a basic string (") with escapes or a
// literal one ('), each also over several lines between triple marks.
std::size_t behind_string(std::string_view text, std::size_t begin) {
  const char mark = text[begin];
  const std::string triple(3, mark);
  const bool several_lines = text.substr(begin).starts_with(triple);
  const std::string closing = several_lines ? triple : std::string(1, mark);
  for (std::size_t i = begin + closing.size(); i < text.size(); ++i) {
    if (mark == '"' && text[i] == '\\') {
      ++i;
    } else if (text.substr(i).starts_with(closing)) {
      return i + closing.size();
    } else if (text[i] == '\n' && !several_lines) {
      return i;  // never closed: the library reports it
    }
  }
  return text.size();
}

TextPlace place_of(std::string_view text, std::size_t position) {
  const std::string_view before = text.substr(0, position);
  const std::size_t line_begin = before.rfind('\n') + 1;  // 0 where there is none
  return {1 + static_cast<int>(std::count(before.begin(), before.end(), '\n')),
          1 + static_cast<int>(position - line_begin)};
}

// The first character outside strings and comments for which `is_wrong` holds.
template <class Character>
std::optional<TextPlace> first_outside_strings(std::string_view text, Character is_wrong) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  std::size_t i = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
  while (i < text.size()) {
    if (text[i] == '"' || text[i] == '\'') {
      i = behind_string(text, i);
    } else if (text[i] == '#') {
      i = std::min(text.find('\n', i), text.size());
    } else if (is_wrong(text[i])) {
      return place_of(text, i);
    } else {
      ++i;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<TextPlace> letter_outside_strings(std::string_view text) {
  return first_outside_strings(text, [](char c) { return static_cast<unsigned char>(c) > 0x7F; });
}

std::optional<TextPlace> end_of_deep_key(std::string_view text) {
  constexpr int deepest = 100;
  int dots = 0;
  return first_outside_strings(text, [&](char c) {
    constexpr std::string_view between_keys = "=,[]{}\n";
    if (between_keys.find(c) != between_keys.npos) dots = 0;
    return c == '.' && ++dots > deepest;
  });
}

}  // namespace slosh
