// The one reader of case files (TOML, verification/cases/*.toml). Strict: an unknown or missing key, a wrong
// type, a value that no tank can have, each is refused with file:line, key, value, what was expected and its
// unit, and the nearest known key.
#pragma once

#include <filesystem>
#include <stdexcept>

#include "verification/case_file/case_definition.hpp"

namespace slosh {

// The user's file is wrong; what() is the whole message, "file:line: key = value: expected ...".
struct CaseFileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

CaseDefinition read_case(const std::filesystem::path& file);

}  // namespace slosh
