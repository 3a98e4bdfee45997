// A text as one word of a shell's command line, whatever is in it: for commands that are shown to
// be repeated, never to be run from here.
#pragma once

#include <string>

namespace slosh {

std::string shell_word(const std::string& text);

}  // namespace slosh
