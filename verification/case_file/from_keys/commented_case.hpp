// A case of the user's own, to be edited: the file of another case, reduced to its theories and one
// SPH run with its gate rows, where each key is explained by the table of keys (key_table.hpp).
#pragma once

#include <string>

#include "verification/case/case_definition.hpp"

namespace slosh {

// Returns the text of the new case file. The kept SPH run is the coarsest of those that a gate row
// judges by a limit. Files that the case names are named by their whole paths. Records that only
// the user has, ensembles, refinements, uncertain inputs and animations are left out. Throws
// CaseFileError for a name that no case may have, and for a case without an SPH run.
std::string commented_case(const CaseDefinition& like, const std::string& name);

}  // namespace slosh
