// Makes a text of others, such as the last words of a program, safe to show.
#pragma once

#include <string>
#include <string_view>

namespace slosh {

// Returns the text without what commands a terminal or makes XML malformed: control sequences
// (ECMA-48, "ESC [ ... letter"), all other control characters of ASCII and of U+0080 to U+009F but
// line breaks and tabs, marks that turn the direction of writing (U+061C, U+200E, U+200F, U+202A to
// U+202E, U+2066 to U+2069), U+FFFE and U+FFFF. U+FFFD stands for each byte that is no UTF-8.
std::string legible(std::string_view text);

// The same of a message that quotes what others wrote, of any length: a line of more than 1000
// bytes keeps its first 500 and its last 300.
std::string legible_message(std::string_view text);

}  // namespace slosh
