// The text of the sources that determine a solver's answer, which the keys of its results hash
// (run_key.hpp). It does not change with comments, layout and the grouping of files in compilation.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>

namespace slosh {

// Returns the tokens of C++ source text, separated by single spaces, without comments. A line ends
// after each ';', '{' and '}' and with each line of the preprocessor.
std::string tokens_of(std::string_view source);

// Returns these sources and all headers that they include by a name in quotes, which is relative to
// `root`, each by its tokens below a line "== NAME". Headers in `left_out` are none of them, nor
// what these alone include. Throws std::filesystem::filesystem_error for a file that cannot be
// read.
std::string text_of_sources(const std::filesystem::path& root, std::set<std::string> sources,
                            const std::set<std::string>& left_out);

}  // namespace slosh
