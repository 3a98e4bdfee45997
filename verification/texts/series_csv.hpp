// Writes the series of a result file as one table.
#pragma once

#include <string>

#include "verification/assessment/references/case_theories.hpp"
#include "verification/results/result_file.hpp"

namespace slosh {

// Writes the theories of a case as one table.

// Returns a line in words on a theory: its range, or why it is outside.
std::string theory_line(const TheoryRemarks& remarks);

// Returns comment lines, which begin with a '#', on the case and on each theory, then the table of
// series_csv().
std::string theory_csv(const CaseDefinition& definition, const CaseTheories& theories);

// Returns comma-separated values: a header, "time [s],elevation@right [m],...", and a line for each
// time at which any series has a value. A cell is empty if its series has no value then. Every
// number can be read back without loss. Throws ResultError for times that do not increase.
std::string series_csv(const RunResult& result);

}  // namespace slosh
