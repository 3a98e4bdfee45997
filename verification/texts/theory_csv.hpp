// Writes the theories of a case as one table.
#pragma once

#include <string>

#include "verification/assessment/references/case_theories.hpp"

namespace slosh {

// Returns a line in words on a theory: its range, or why it is outside.
std::string theory_line(const TheoryRemarks& remarks);

// Returns comment lines, which begin with a '#', on the case and on each theory, then the table of
// series_csv().
std::string theory_csv(const CaseDefinition& definition, const CaseTheories& theories);

}  // namespace slosh
