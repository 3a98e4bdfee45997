// Patterns of names in case and campaign files, as in a shell: "recommended_*", "*_10mm".
#pragma once

#include <fnmatch.h>

#include <string>

namespace slosh {

inline bool matches_pattern(const std::string& pattern, const std::string& name) {
  return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

}  // namespace slosh
