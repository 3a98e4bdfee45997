// The gate rows of a whole campaign, sorted from the worst to the best.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"
#include "verification/assessment/problem_assessment.hpp"

namespace slosh {

// Rows are sorted by is_worse() of verdict_matrix.hpp. Rows that were not judged (not selected, not
// supplied) are left out. The table has all rows that do not pass, and at least
// `fewest` rows where there are as many; the caption states the number of all rows.
reports::Table worst_first_table(const std::vector<CaseAssessment>& cases,
                                 const std::vector<ProblemAssessment>& problems,
                                 std::size_t fewest = 20);

// Returns what decides the campaign, and its place in the report: the worst row, of those with its
// verdict the worst that does not judge OpenFOAM, with its figure and its limit, and for an
// inconclusive one what would decide it; where a run without a row decides, the run and why; where
// all rows pass, the row nearest to its limit.
reports::Decision decision_of(const std::vector<CaseAssessment>& cases,
                              const std::vector<ProblemAssessment>& problems);

// Returns the candidate of the case's worst judged row; "" where none is judged.
std::string worst_candidate(const CaseAssessment& assessment);

}  // namespace slosh
