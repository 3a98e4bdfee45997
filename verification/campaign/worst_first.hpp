// The gate rows of a whole campaign, the one nearest to its bound, or furthest beyond it, first.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "reports/report_model.hpp"
#include "verification/campaign/case_assessment.hpp"
#include "verification/campaign/problem_assessment.hpp"

namespace slosh {

// Rows that are not judged (not selected, not supplied) are left out. Those that fail without a
// number come first, then all by their share of the tolerance (tolerance_share.hpp), and rows that
// have none, passing improvements, last. All that do not pass, and `fewest` in any case, where
// there are as many; the caption tells how many there are in all.
reports::Table worst_first_table(const std::vector<CaseAssessment>& cases,
                                 const std::vector<ProblemAssessment>& problems,
                                 std::size_t fewest = 20);

}  // namespace slosh
