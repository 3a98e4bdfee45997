// What `compare` lists of the impacts in two pressures, and `converge` of a study.
#pragma once

#include <string>

#include "verification/assessment/convergence.hpp"
#include "verification/case/case_definition.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {

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
