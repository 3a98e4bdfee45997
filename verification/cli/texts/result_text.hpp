// What is told of the result of a run, its series as a table, what `compare` lists of the impacts
// in two pressures, and what `converge` tells of a study.
#pragma once

#include <string>

#include "verification/assessment/convergence.hpp"
#include "verification/assessment/references/case_theories.hpp"
#include "verification/case/case_definition.hpp"
#include "verification/results/result_file.hpp"
#include "verification/runs/sph_step.hpp"
#include "verification/series/time_series.hpp"

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

// Whether the quantity is the pressure, unfiltered or filtered, of the case's impacts.
bool has_impacts(const CaseDefinition& definition, const std::string& quantity);

// For each impact a line of the candidate, one of the reference and one of what is published:
// "impact_1 of the candidate: peak 5260 Pa at 0.4512 s, rise time 0.0123 s, arrival 0.4301 s,
// impulse 310 Pa s". Where a plateau is published, its mean pressure follows in the same way, with
// the difference to the published one. A series that cannot be searched has one line that says why.
std::string impact_lines(const CaseDefinition& definition, const TimeSeries& candidate,
                         const TimeSeries& reference);

struct ConvergenceStudy {
  CaseAssessment assessment;
  ConvergenceQuestion question;
  Convergence found;
};

std::string text_of(const ConvergenceStudy& study);

// The units stand in the keys or beside the values. A missing number is null.
std::string json_of(const ConvergenceStudy& study);

}  // namespace slosh
