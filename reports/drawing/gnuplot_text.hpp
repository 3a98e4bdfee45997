// Text in gnuplot's programs.
#pragma once

#include <string>

namespace slosh::reports {

// A string literal of gnuplot, in which it expands nothing. Control characters, which would break
// the script's lines and an SVG's validity, become blanks.
std::string quoted(const std::string& text);

// Width in px as drawn, near enough to lay labels out; UTF-8 continuation bytes have none.
double text_width(const std::string& text, double character_width);

}  // namespace slosh::reports
