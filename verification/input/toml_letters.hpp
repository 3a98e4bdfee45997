// Where a TOML text has a character beyond ASCII outside its strings and comments. TOML 1.0 allows
// none there, and toml++ 3.3 has undefined behaviour for some of them, so they are refused before
// that library sees the text.
#pragma once

#include <optional>
#include <string_view>

namespace slosh {

struct TextPlace {
  int line, column;  // from 1; the column counts bytes
};

// The first such character; none where there is none. A byte order mark at the very beginning is
// allowed. Text after a string that is never closed counts as part of that string: the library
// reports it.
std::optional<TextPlace> letter_outside_strings(std::string_view text);

}  // namespace slosh
