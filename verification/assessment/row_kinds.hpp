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

// Counts the judged rows by what they rest on, and those whose reference has an unknown
// uncertainty: "Rows: 38 against exact solutions, 15 own tolerances, 16 regression, 0 experiments."
// Returns "" where there is no row.
std::string basis_sentence(const std::vector<CaseAssessment>& cases,
                           const std::vector<ProblemAssessment>& problems);

}  // namespace slosh
