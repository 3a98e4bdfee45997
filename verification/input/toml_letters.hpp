// Finds what is refused before toml++ sees the text: characters beyond ASCII outside strings and
// comments, which TOML 1.0 does not allow and for some of which toml++ 3.3 has undefined behaviour,
// and keys such as a.a.a, each of whose parts is a table in the one before, by recursion.
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

// Returns where a key has its 101st dot, or nullopt.
std::optional<TextPlace> end_of_deep_key(std::string_view text);

}  // namespace slosh
