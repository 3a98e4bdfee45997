// The observed order of convergence of a scheme's errors with the particle spacing h,
//   p = ln(e_1 / e_2) / ln(h_1 / h_2)  between two spacings,
// and over all of them the slope of the least-squares line through (ln h, ln |e|) (Roache 1998,
// Verification and Validation in Computational Science and Engineering, section 5.10, for p between
// grids with a known solution).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/convergence/power_law_line.hpp"

namespace slosh {

// An error at a spacing [m]; its half width is zero where it has no interval.
struct ErrorAtSpacing {
  double spacing;
  Estimate error;
};

// Returns nullopt where an error is zero, NaN or smaller than its own interval, which is the
// uncertainty of the fit.
std::optional<double> observed_order(const ErrorAtSpacing& coarse, const ErrorAtSpacing& fine);

// Uses the errors that are larger than their intervals. Returns nullopt for fewer than three of
// them.
std::optional<double> least_squares_order(const std::vector<ErrorAtSpacing>& errors);
std::optional<PowerLawLine> least_squares_line(const std::vector<ErrorAtSpacing>& errors);

// One error measure of runs that differ in their spacing alone.
struct ErrorFamily {
  std::string name;     // the scheme, the external program's method, or the path of meshes
  std::string measure;  // "normalised rms [%]"
  double scale;         // from the errors to that unit
  std::vector<ErrorAtSpacing> errors;
};

// Covers each scheme that runs unchanged, and each method of an external program, at three or more
// spacings and is compared with theory or a record there: one family for each of the three
// measures, in the same order for every scheme.
std::vector<ErrorFamily> scheme_error_families(const CaseAssessment& assessment);

// Those families, and the same measures of each [[refinement]] over three or more meshes.
std::vector<ErrorFamily> error_families(const CaseAssessment& assessment);

}  // namespace slosh
