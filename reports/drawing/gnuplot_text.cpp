#include "reports/drawing/gnuplot_text.hpp"

#include <algorithm>

namespace slosh::reports {

std::string quoted(const std::string& text) {
  std::string literal = "'";
  for (const char c : text) {
    if (c == '\'') literal += '\'';
    literal += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
  }
  return literal + "'";
}

double text_width(const std::string& text, double character_width) {
  const auto characters = std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  });
  return character_width * static_cast<double>(characters);
}

}  // namespace slosh::reports
