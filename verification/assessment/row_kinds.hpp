// What the gate rows of a campaign rest on, counted: of a limit that was measured before a passing
// row tells only that nothing has become worse.
#pragma once

#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/assessment/problem_assessment.hpp"

namespace slosh {

enum class RowBasis {
  experiment,           // a record, or published impacts
  exact_solution,       // theory, potential flow, a problem's solution
  harness_tolerance,    // against another method, or of what is zero where all is right
  earlier_measurement,  // a regression row, whatever its reference is
};

RowBasis basis_of(const CaseDefinition& definition, const GateRow& row);

// Of the rows that were judged: those of either kind and how many of them pass, the share that
// rests on an experiment, an exact solution or a tolerance of this harness, and how many have a
// reference of unknown uncertainty. "" without a row.
std::string kinds_sentence(const std::vector<CaseAssessment>& cases,
                           const std::vector<ProblemAssessment>& problems);

}  // namespace slosh
