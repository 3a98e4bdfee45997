#include "reports/drawing/text_lines.hpp"

#include <algorithm>
#include <string_view>

namespace slosh::reports {

double text_width(const std::string& text, double character_width) {
  const auto characters = std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  });
  return character_width * static_cast<double>(characters);
}

std::vector<std::string> wrapped(std::string rest, double width, double character_width) {
  std::vector<std::string> lines;
  while (text_width(rest, character_width) > width) {
    std::size_t end = std::string::npos;
    for (const std::string_view gap : {", ", " "}) {
      for (auto at = rest.find(gap); at != std::string::npos; at = rest.find(gap, at + 1)) {
        const std::size_t blank = at + gap.size() - 1;
        if (text_width(rest.substr(0, blank), character_width) <= width) end = blank;
      }
      if (end != std::string::npos) break;
    }
    if (end == std::string::npos) end = rest.find(' ');
    if (end == std::string::npos) break;
    lines.push_back(rest.substr(0, end));
    rest.erase(0, end + 1);
  }
  lines.push_back(rest);
  return lines;
}

}  // namespace slosh::reports
