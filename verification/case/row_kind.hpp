// The key `kind` of a gate row, of a case and of a problem alike: "validation" where its limit
// comes from theory, an experiment, a standard, a requirement or a tolerance that this harness
// states, "regression" where it comes from what was measured before. A row without the key is a
// validation row, the stricter of the two.
#pragma once

#include <string>

#include "verification/case/case_definition.hpp"
#include "verification/input/toml_reader.hpp"

namespace slosh {

// Throws CaseFileError of any other text.
RowKind read_row_kind(const TomlTable& row);

std::string kind_name(RowKind kind);  // as in the case file

}  // namespace slosh
