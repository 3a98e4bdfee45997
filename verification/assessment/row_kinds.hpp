// The number of a campaign's gate rows by what they rest on. A row whose limit was measured before
// only shows that nothing has become worse.
#pragma once

#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/assessment/problem_assessment.hpp"

namespace slosh {

enum class RowBasis {
  experiment,           // a record, or published impacts
  exact_solution,       // theory, potential flow, a problem's solution
  harness_tolerance,    // another method, or a metric that is zero in a correct run
  earlier_measurement,  // a regression row, whatever its reference is
};

RowBasis basis_of(const CaseDefinition& definition, const GateRow& row);

// Counts the judged rows: those of either kind and how many of them pass, the percentage that rests
// on an experiment, an exact solution or a tolerance of this harness, and the rows whose reference
// has an unknown uncertainty. Returns "" where there is no row.
std::string kinds_sentence(const std::vector<CaseAssessment>& cases,
                           const std::vector<ProblemAssessment>& problems);

}  // namespace slosh
