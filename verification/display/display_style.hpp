// What an output of the process (a terminal, a file) can show.
#pragma once

#include <functional>

namespace slosh {

struct DisplayStyle {
  bool live;    // a terminal: lines may be drawn anew, and break at its width
  bool colour;  // ANSI colours
  int columns;  // of the terminal
};

// Returns the style of standard output or error (STDOUT_FILENO, STDERR_FILENO). It is live on a
// terminal that is not "dumb", with colour unless NO_COLOR is set and not empty (no-color.org).
DisplayStyle style_of(int descriptor);

// Is called before each drawing, for a user may resize the terminal.
using AskStyle = std::function<DisplayStyle()>;
inline AskStyle style_now_of(int descriptor) {
  return [descriptor] { return style_of(descriptor); };
}

// ANSI X3.64 (ECMA-48) sequences.
inline constexpr const char *green = "\033[32m", *red = "\033[31m", *yellow = "\033[33m",
                            *normal = "\033[0m";

}  // namespace slosh
