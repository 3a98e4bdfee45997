// Finds characters beyond ASCII outside the strings and comments of a TOML text. TOML 1.0 does not
// allow them, and toml++ 3.3 has undefined behaviour for some of them; they are refused before the
// library sees the text.
#pragma once

#include <optional>
#include <string_view>

namespace slosh {

struct TextPlace {
  int line, column;  // from 1; the column counts bytes
};

// Returns the first such character, or nullopt. A byte order mark at the very beginning is allowed.
// Text after a string that is never closed counts as part of the string; the library reports it.
std::optional<TextPlace> letter_outside_strings(std::string_view text);

}  // namespace slosh
