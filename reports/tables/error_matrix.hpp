// Closure: how far each kind of solution of a case is from every other, and which one stands apart.
// The distance of two histories of the case's first quantity, over their common part of the window,
//   d = rms(a - b) / sqrt(rms(a') rms(b')),   a' = a less its mean,
// is the same both ways. One member stands apart where its mean distance to the others is more than
// twice the mean distance among the others.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"

namespace slosh {

// distances[i][j], symmetric, of at least three members; the index of the one that stands apart.
std::optional<std::size_t> odd_one_out(const std::vector<std::vector<double>>& distances);

// Of the finest run of each SPH scheme as it is, of the finest interFoam, and of every reference
// and record; those outside their range are shown and marked. Nothing of fewer than three.
std::optional<reports::Table> error_matrix(const CaseAssessment& assessment);

}  // namespace slosh
