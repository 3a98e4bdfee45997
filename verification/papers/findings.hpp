// The evidence of papers' claims: one named function for each kind of finding. A row of
// paper_claims.cpp names the function, what it is evaluated on, and the thresholds.
#pragma once

#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/papers/claims.hpp"

namespace slosh {

struct FindingRow;
using Evidence = Finding (*)(const std::vector<CaseAssessment>& cases, const FindingRow& row);

struct FindingRow {
  Evidence evidence;
  std::vector<std::string> cases;  // by name
  // The names that the function expects, in its order. The first run is the one that the claim is
  // about.
  std::vector<std::string> runs;
  std::string name = {};      // of the quantity, in the finding's text
  std::string quantity = {};  // a series or a fitted mode, where the function needs one
  std::vector<Threshold> thresholds;
  std::vector<double> printed = {};  // the paper's numbers, where the function compares with them
  // Whether the claim is about the flow, so that interFoam gives a second finding: the finest run
  // of the first case that has three repeats or more, or the finest of all where none has.
  bool by_finest_mesh_too = false;
};

// Each function below throws std::runtime_error where a case, a run, a series or a number is
// missing. "Threshold" lists what the row's thresholds are, in their order.
namespace evidence {

// Frequency or amplitude error of the fitted mode `quantity`, runs[0] against runs[1]. Threshold:
// range of the relative error.
Finding frequency_against_theory(const std::vector<CaseAssessment>& cases, const FindingRow& row);
Finding amplitude_against_theory(const std::vector<CaseAssessment>& cases, const FindingRow& row);

// Skewness of the elevation of runs[1] minus that of runs[0], at the first gauge. Threshold: least
// difference.
Finding flattened_crests(const std::vector<CaseAssessment>& cases, const FindingRow& row);

// Highest elevation at the first gauge. Thresholds: least elevation over the depth, least crest
// height over trough depth.
Finding violent_motion(const std::vector<CaseAssessment>& cases, const FindingRow& row);

// The spectral peaks at the excitation and at twice it, in cases[0] of the smaller and cases[1] of
// the larger amplitude. Thresholds: range of the relative difference in frequency, least growth of
// the power.
Finding peaks_at_multiples(const std::vector<CaseAssessment>& cases, const FindingRow& row);

// The power of the first of those peaks over that of the second. Thresholds: least growth from
// cases[0] to cases[1], factor to the printed ratios.
Finding growth_of_peak_ratio(const std::vector<CaseAssessment>& cases, const FindingRow& row);

// The pressure of runs[0] against the record runs[1]: the lag of the forced tone, and the rms
// difference of the two without their means. Threshold: range of the lag [deg], of the difference.
Finding phase_against_record(const std::vector<CaseAssessment>& cases, const FindingRow& row);
Finding shape_against_record(const std::vector<CaseAssessment>& cases, const FindingRow& row);

// The rms difference of `quantity` between runs[0] and runs[1], filtered as the case's pressure;
// "wall_pressure" is that at the filtered gauge. Threshold: range of the difference.
Finding difference_of_runs(const std::vector<CaseAssessment>& cases, const FindingRow& row);

// The impacts of runs[0] against the published ones. Thresholds: largest delay over the period;
// range of the plateau's relative error; range of a peak's percentile among the repeats [%], its
// range in their standard deviations where the table of the repeats is not supplied, largest number
// of peaks outside.
Finding impact_times(const std::vector<CaseAssessment>& cases, const FindingRow& row);
Finding plateau_against_published(const std::vector<CaseAssessment>& cases, const FindingRow& row);
Finding peaks_among_repeats(const std::vector<CaseAssessment>& cases, const FindingRow& row);

// Fixed against moving boundary particles, each run of a study made with both: runs are the names
// after "fixed_" and "moving_". The runs that finish, the noise on the plateau and the wall
// crossings; the rms difference of the filtered pressure to the last, finest run. Threshold:
// largest ratio of fixed to moving that counts as smaller. A difference of the crossings must also
// exceed the scatter of such counts.
Finding fixed_more_stable(const std::vector<CaseAssessment>& cases, const FindingRow& row);
Finding fixed_converges_better(const std::vector<CaseAssessment>& cases, const FindingRow& row);

}  // namespace evidence
}  // namespace slosh
