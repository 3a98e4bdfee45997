// The files that a program may read because the text of a script, of a table of settings or of an
// argument names them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace slosh {

// Returns the regular files that the words of a text name, relative to one of these directories or
// whole; behind a variable that stands for a directory too ("$HERE/solve"). A word of a script also
// names a module: mine.py, mine/__init__.py or mine/fast.py of a script in Python that says `mine`
// or `mine.fast`. What stands behind a # is a comment. Only the first 1e6 bytes are read, and of a
// file that is no text nothing. Files of the system are left out (shared_libraries.hpp).
std::vector<std::filesystem::path> files_named_in(
    const std::filesystem::path& text, const std::vector<std::filesystem::path>& directories);

// Returns those that the words of an argument name, also one that is glued to a letter
// ("-pcase.txt"), and for a word without a suffix those that have one: Case.xml for "Case".
std::vector<std::filesystem::path> files_meant_by(
    const std::string& argument, const std::vector<std::filesystem::path>& directories);

}  // namespace slosh
