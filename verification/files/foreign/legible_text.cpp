#include "verification/files/foreign/legible_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/locale/utf.hpp>

namespace slosh {
namespace {

using Utf8 = boost::locale::utf::utf_traits<char>;

constexpr char escape = '\x1b';
constexpr char32_t no_break_space = 0xa0;

bool is_shown(boost::locale::utf::code_point character) {
  const auto within = [&](char32_t first, char32_t last) {
    return character >= first && character <= last;
  };
  if (character == U'\n' || character == U'\t') return true;
  return !within(0, 0x1f) && !within(0x7f, 0x9f) && character != 0xad && character != 0x061c &&
         character != 0x200b && !within(0x200e, 0x200f) && !within(0x202a, 0x202e) &&
         !within(0x2066, 0x2069) && !within(0xfffe, 0xffff);
}

// Of a string that is meant for the terminal, such as the address of a link, to the mark of its end
// or of the line's.
std::size_t length_of_command(std::string_view text) {
  const std::size_t end = std::min(text.find_first_of("\a\n\x1b", 2), text.size());
  if (end == text.size() || text[end] == '\n') return end;
  return end + (text.substr(end).starts_with("\x1b\\") ? 2 : text[end] == '\a' ? 1 : 0);
}

// Of the control sequence that the text begins with; 1 for another use of the escape character.
std::size_t length_of_sequence(std::string_view text) {
  if (text.size() < 2) return 1;
  if (std::string_view("]PX^_").find(text[1]) != text.npos) return length_of_command(text);
  if (text[1] != '[') return 1;
  const auto last = std::find_if(text.begin() + 2, text.end(),
                                 [](char letter) { return letter < '\x20' || letter > '\x3f'; });
  const bool is_whole = last != text.end() && *last >= '\x40' && *last <= '\x7e';
  return static_cast<std::size_t>(last - text.begin()) + (is_whole ? 1 : 0);
}

// Takes the last character of the line back, as a terminal types over it.
void step_back(std::string& shown) {
  const auto is_inside = [](char byte) {
    return (static_cast<unsigned char>(byte) & 0xc0) == 0x80;
  };
  if (shown.empty() || shown.back() == '\n') return;
  while (shown.size() > 1 && is_inside(shown.back())) shown.pop_back();
  shown.pop_back();
}

}  // namespace

std::string legible(std::string_view text) {
  std::string shown;
  shown.reserve(text.size());
  for (auto at = text.begin(); at != text.end();) {
    const auto begin = at;
    if (*begin == escape) {
      at += static_cast<std::ptrdiff_t>(length_of_sequence(text.substr(begin - text.begin())));
      continue;
    }
    if (*begin == '\b') {
      step_back(shown);
      ++at;
      continue;
    }
    const auto character = Utf8::decode(at, text.end());
    if (!boost::locale::utf::is_valid_codepoint(character)) {
      at = begin + 1;
      shown += "\uFFFD";
    } else if (character == no_break_space) {
      shown += ' ';
    } else if (is_shown(character)) {
      shown.append(begin, at);
    }
  }
  return shown;
}

std::string legible_message(std::string_view text) {
  constexpr std::size_t longest = 1000, first = 500, last = 300;
  std::string shown;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    if (line.size() <= longest)
      shown += line;
    else
      shown += fmt::format("{} ... ({} characters) ... {}", line.substr(0, first), line.size(),
                           line.substr(line.size() - last));
    if (end < text.size()) shown += '\n';
    begin = end + 1;
  }
  return legible(shown);
}

}  // namespace slosh
