// What one of the process's outputs can show.
#pragma once

#include <functional>

namespace slosh {

struct DisplayStyle {
  bool live;    // a terminal: lines may be drawn anew, and break at its width
  bool colour;  // ANSI colours
  int columns;  // of the terminal
};

// Of standard output or error (STDOUT_FILENO, STDERR_FILENO): live on a terminal that is not
// "dumb", colour there unless NO_COLOR is set and not empty (no-color.org).
DisplayStyle style_of(int descriptor);

// Asked at each showing: a user may resize the terminal.
using AskStyle = std::function<DisplayStyle()>;
inline AskStyle style_now_of(int descriptor) {
  return [descriptor] { return style_of(descriptor); };
}

// ANSI X3.64 (ECMA-48) sequences.
inline constexpr const char *green = "\033[32m", *red = "\033[31m", *yellow = "\033[33m",
                            *normal = "\033[0m";

}  // namespace slosh
