// Suggests what the user may have meant: the known names nearest to a wrong one, by the edit
// distance of V. I. Levenshtein (1966), the smallest number of insertions, deletions and
// replacements of characters.
#pragma once

#include <fnmatch.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace slosh {

// Patterns of names in case and campaign files, as in a shell: "recommended_*", "*_10mm".

inline bool matches_pattern(const std::string& pattern, const std::string& name) {
  return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

std::size_t edit_distance(std::string_view a, std::string_view b);

// Returns at most `count` of the known names, the nearest first. Equally near ones keep their
// order.
std::vector<std::string> nearest_names(std::string_view wrong, std::vector<std::string> known,
                                       std::size_t count);

// Returns what a name must be: "a run, one of fine, coarse", "a unit, which is m", "a mode, of
// which there is none".
std::string one_of_text(std::string_view expected, const std::vector<std::string>& known);
// Returns "; nearest: coarse", or an empty text if no name is known.
std::string nearest_text(std::string_view wrong, const std::vector<std::string>& known);

}  // namespace slosh
