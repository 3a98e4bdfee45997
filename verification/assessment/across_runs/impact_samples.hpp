// The impact pressures of a case's runs: which runs repeat one another, and
// their peaks as a sample beside the experiment's. A single impact cannot be predicted; the
// distribution of its peak can.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/case/quantities.hpp"
#include "verification/gate/distributions/peak_comparison.hpp"

namespace slosh {

// Where a peak [Pa] lies among the experiment's: "43 %" of the repeats are lower, or, where the
// table of the repeats is not supplied, "-0.3 sd" from the published mean.
std::string place_among_repeats(const CaseDefinition& definition, std::size_t impact, double peak);

// The members of each ensemble, and the SPH runs that differ in start_seed only, in the order of
// the case file; two or more in each group.
std::vector<std::vector<const RunDefinition*>> repeated_runs(const CaseDefinition& definition);

// The peaks of one impact over repeated runs.
struct PeakSample {
  std::vector<double> peaks;          // [Pa], of the repeats in which the impact occurred
  std::size_t usable = 0;             // repeats with a usable pressure series
  std::vector<std::string> left_out;  // the others, each with the reason
};
PeakSample peak_sample(const CaseAssessment& assessment,
                       const std::vector<const RunDefinition*>& repeats,
                       const std::string& pressure, std::size_t impact);

// How the sample compares with the experiment's repeats of that impact. Returns nullopt where their
// table is not supplied, and for fewer peaks than fewest_repeats.
std::optional<PeakComparison> against_experiment(const CaseDefinition& definition,
                                                 const PeakSample& sample, std::size_t impact);

// "median 1.12 (0.95 to 1.30) times the experiment's, p 0.04 of equal means by Welch, 0.03 by
// Kolmogorov and Smirnov and 0.02 by Anderson and Darling"
std::string comparison_text(const PeakComparison& comparison);

// "1.12 (0.95 to 1.30)": the ratio of the medians with its 95 % interval.
std::string median_ratio_text(const PeakComparison& comparison);

}  // namespace slosh
