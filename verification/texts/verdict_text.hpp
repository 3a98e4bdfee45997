// Formats lines of verdicts for a terminal or a file.
#pragma once

#include <string>

#include "verification/display/display_style.hpp"

namespace slosh {

// On a terminal, lines longer than its width are broken between words and indented, and the verdict
// at the beginning of a line is coloured if colours are allowed (green: passed; red: violated or
// solver failed; yellow: undecided). Elsewhere the text is unchanged.
std::string as_shown(const std::string& text, const DisplayStyle& style);

}  // namespace slosh
