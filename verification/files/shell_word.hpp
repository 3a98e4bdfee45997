// Quotes a text as one word of a shell's command line. It serves commands that are shown for the
// user to repeat; no command is run by a shell here.
#pragma once

#include <string>

namespace slosh {

inline std::string shell_word(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + "'";
}

}  // namespace slosh
