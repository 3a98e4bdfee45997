// The one reader of case files (TOML, verification/cases/*.toml). It is strict: it refuses an
// unknown or missing key, a wrong type and a value that no tank can have, each with file:line, key,
// value, what was expected and its unit, and the nearest known key. key_table.hpp lists the keys,
// docs/case_file.md shows them. The names of SPH schemes and of their variants are not known here:
// whoever starts a run checks its own.
#pragma once

#include <filesystem>
#include <string>

#include "verification/case/case_definition.hpp"
#include "verification/input/case_file_error.hpp"

namespace slosh {

// `experiments` is the directory of the user's records, empty where none is named; a record that is
// not there is read as not supplied. Throws CaseFileError; of all that is wrong in the file's
// tables CaseFileErrors (complaints.hpp), but for what may only follow from another mistake.
CaseDefinition read_case(const std::filesystem::path& file,
                         const std::filesystem::path& experiments = {});

// The file of a case: a path (it holds a / or ends in .toml), or the name of a case in the
// directory. Throws CaseFileError when there is none, with the nearest names.
std::filesystem::path find_case(const std::string& name_or_path,
                                const std::filesystem::path& directory);

}  // namespace slosh
