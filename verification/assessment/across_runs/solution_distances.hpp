// How far the solutions of a case are from one another. The distance of two time series of the
// case's first quantity, over their common part of the comparison window,
//   d = rms(a - b) / sqrt(rms(a') rms(b')),   a' = a less its mean,
// is symmetric. A solution is an outlier where its mean distance to the others is more than twice
// the mean distance among the others.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"

namespace slosh {

// Returns the index of the outlier of a symmetric matrix of distances, nullopt where there is none.
// Distances that are NaN are left out.
std::optional<std::size_t> outlier(const std::vector<std::vector<double>>& distances);

struct SolutionDistances {
  std::string quantity;
  std::vector<std::string> runs;               // in the order of the case file
  std::vector<std::vector<double>> distances;  // [run][run]; NaN of a pair that cannot be compared
};

// Compares the finest unchanged run of each SPH scheme, the finest interFoam run, and every
// reference and record, those outside their range included.
SolutionDistances solution_distances(const CaseAssessment& assessment);

}  // namespace slosh
