#include "verification/texts/verdict_text.hpp"

#include <algorithm>
#include <sstream>
#include <utility>
#include <vector>

#include "verification/gate/gate.hpp"

namespace slosh {
namespace {

// Returns the words with which a line of a verdict may begin, and their colours.
std::vector<std::pair<std::string, const char*>> coloured_words() {
  return {
      {verdict_name(Verdict::pass), green},          {verdict_name(Verdict::violated), red},
      {verdict_name(Verdict::solver_failed), red},   {verdict_name(Verdict::inconclusive), yellow},
      {verdict_name(Verdict::not_compared), yellow}, {headline_word(exit_pass), green},
      {headline_word(exit_violated), red},           {headline_word(exit_inconclusive), yellow},
      {headline_word(exit_not_compared), yellow}};
}

std::string coloured(const std::string& line) {
  for (const auto& [word, colour] : coloured_words()) {
    const bool ends =
        line.size() > word.size() && (line[word.size()] == ' ' || line[word.size()] == ':');
    if (line.starts_with(word) && ends) return colour + word + normal + line.substr(word.size());
  }
  return line;
}

std::string broken(std::string line, std::size_t columns) {
  const std::string indent(std::min<std::size_t>(columns / 8, 4), ' ');
  std::string lines;
  std::size_t begin = 0;  // of the first word in the line
  while (line.size() > columns) {
    std::size_t at = line.rfind(' ', columns);
    if (at == std::string::npos || at <= begin)
      at = line.find(' ', begin);  // a word longer than the line
    if (at == std::string::npos) break;
    lines += line.substr(0, at) + '\n';
    line = indent + line.substr(at + 1);
    begin = indent.size();
  }
  return lines + line;
}

}  // namespace

std::string as_shown(const std::string& text, const DisplayStyle& style) {
  if (!style.live) return text;
  std::string shown;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    line = broken(line, static_cast<std::size_t>(std::max(style.columns, 1)));
    shown += (style.colour ? coloured(line) : line) + '\n';
  }
  return shown;
}

}  // namespace slosh
