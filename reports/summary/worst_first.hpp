// The gate rows of a whole campaign, the one nearest to its bound, or furthest beyond it, first.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"
#include "verification/assessment/problem_assessment.hpp"

namespace slosh {

// By verdict first (severity() of tolerance_share.hpp), then by how far the 95 % interval reaches:
// (|value| + half width) / limit. Of one verdict rows without a number come first where they do not
// pass, and last where they do. Rows that are not judged (not selected, not supplied) are left out.
// All that do not pass, and `fewest` in any case, where there are as many; the caption tells how
// many there are in all.
reports::Table worst_first_table(const std::vector<CaseAssessment>& cases,
                                 const std::vector<ProblemAssessment>& problems,
                                 std::size_t fewest = 20);

// The first of them where it alone would lead to the campaign's exit status, with its place in the
// report; without a text where all rows pass or a run decides that no row names.
reports::Link deciding_row(const std::vector<CaseAssessment>& cases,
                           const std::vector<ProblemAssessment>& problems);

}  // namespace slosh
