// The parser of case files (TOML, verification/cases/*.toml). It is strict: it refuses an unknown
// or missing key, a wrong type and an impossible value. Each message has file:line, the key, the
// value, what was expected with its unit, and the nearest known key. key_table.hpp lists the keys,
// `slosh explain --keys` documents them. The parser does not know the names of SPH schemes and
// variants: these are checked when a run starts.
#pragma once

#include <filesystem>
#include <string>

#include "verification/case/case_definition.hpp"
#include "verification/input/case_file_error.hpp"

namespace slosh {

// `experiments` is the directory of the user's records; it may be empty. A record that is absent is
// read as not supplied. Throws CaseFileError; for mistakes in the file's tables CaseFileErrors with
// all of them, except those that may only follow from another one.
CaseDefinition read_case(const std::filesystem::path& file,
                         const std::filesystem::path& experiments = {});

// Returns the file of a case, given as a path (it contains a / or ends in .toml) or as the name of
// a case in the directory. Throws CaseFileError with the nearest names if there is no such file.
std::filesystem::path find_case(const std::string& name_or_path,
                                const std::filesystem::path& directory);

}  // namespace slosh
