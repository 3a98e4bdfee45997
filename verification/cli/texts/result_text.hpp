// What is told of the result of a run, and its series as a table.
#pragma once

#include <string>

#include "verification/assessment/references/case_theories.hpp"
#include "verification/case/case_definition.hpp"
#include "verification/results/result_file.hpp"
#include "verification/runs/sph_step.hpp"

namespace slosh {

// Returns for each gauge the highest and lowest value, their times and the period of the highest
// spectral peak, followed by the cost and, for SPH, the time steps.
std::string run_summary(const RunResult& result, const CaseDefinition& definition,
                        const RunDefinition& run);

// Returns "0.625 ms each: landing on the samples every 10 ms shortens the stable 0.637 ms by 2 %"
std::string step_text(const SphStep& step, double sample_interval);

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
