// Texts as gnuplot draws them: how wide they are, and where they break into lines.
#pragma once

#include <string>
#include <vector>

namespace slosh::reports {

// The approximate width [px] of a text as drawn, to lay labels out; each UTF-8 character counts
// once.
double text_width(const std::string& text, double character_width);

// Breaks a text into lines of at most this width [px], as gnuplot does not. A line ends at the last
// comma within the width or, where there is none, at the last blank within it. A word that is wider
// has a line of its own.
std::vector<std::string> wrapped(std::string text, double width, double character_width);

}  // namespace slosh::reports
