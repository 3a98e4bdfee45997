// Lines of verdicts as an output shows them.
#pragma once

#include <string>

#include "verification/display/display_style.hpp"

namespace slosh {

// On a terminal: lines that are longer than it is wide break between words and go on indented, and
// the verdict that a line begins with has its colour (green: it holds; red: it is violated or the
// solver failed; yellow: nothing was decided) where colours may be. Elsewhere the text as it is, so
// that each line remains one.
std::string as_shown(const std::string& text, const DisplayStyle& style);

}  // namespace slosh
