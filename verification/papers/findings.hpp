// The evidence of papers' claims: one named function for each kind of finding. A claim's row names
// the function, what it is evaluated on, and the thresholds.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/papers/claims.hpp"
#include "verification/papers/measured_values.hpp"

namespace slosh {

struct FindingRow;
using Evidence = Finding (*)(const std::vector<CaseAssessment>& cases, const FindingRow& row);

struct FindingRow {
  Evidence evidence = nullptr;
  std::vector<std::string> cases = {};  // by name
  // The names that the function expects, in its order. The first run is the one that the claim is
  // about.
  std::vector<std::string> runs = {};
  std::string name = {};      // of the number, in the finding's text
  std::string quantity = {};  // a series or a fitted mode, where the function needs one
  // What ratio() and against_printed() measure, and what ratio() divides by: the same unless told.
  Measured of = {};
  std::optional<Measured> over = {};
  std::vector<Threshold> thresholds = {};
  std::optional<double> printed = {};  // the paper's number, by which the measured one is divided
  // Whether the claim is about the flow, so that interFoam gives a second finding: the finest run
  // of the first case that has three repeats or more, or the finest of all where none has.
  bool by_finest_mesh_too = false;
  // Whether single runs say nothing, as their histories are chaotic and the claim compares two.
  bool by_repeats = false;
};

// "Grows", "is larger": by a tenth at least. "Clearly": by a quarter. Equality refutes both.
inline const Threshold grows = at_least_between(1, 1.1), clearly_more = at_least_between(1, 1.25);

// Each function below throws std::runtime_error where a case, a run, a series or a number is
// missing. "Threshold" lists what the row's thresholds are, in their order.
namespace evidence {

// The measure `of` of runs.front() in cases.back() over the measure `over` of runs.back() in
// cases.front(): the growth from a first case to a second, the ratio of a first run to a second, or
// of two measures of one run. Geometric means over ensembles, with their interval. Threshold: that
// of the ratio.
Finding ratio(const std::vector<CaseAssessment>& cases, const FindingRow& row);

// The measure `of` of runs[0] in cases[0] over the printed number. Threshold: that of the quotient.
Finding against_printed(const std::vector<CaseAssessment>& cases, const FindingRow& row);

// Frequency or amplitude error of the fitted mode `quantity`, runs[0] against runs[1]. Threshold:
// range of the relative error.
Finding frequency_against_theory(const std::vector<CaseAssessment>& cases, const FindingRow& row);
Finding amplitude_against_theory(const std::vector<CaseAssessment>& cases, const FindingRow& row);

// Skewness of the elevation of runs[1] minus that of runs[0], at the first gauge. Threshold: that
// of the difference.
Finding flattened_crests(const std::vector<CaseAssessment>& cases, const FindingRow& row);

// The lag of the elevation's forced tone at the first gauge, runs[0] behind runs[1] [deg].
// Threshold: range of the lag.
Finding lag_of_runs(const std::vector<CaseAssessment>& cases, const FindingRow& row);

// Thresholds: the highest elevation at the first gauge over the depth; how far the highest wet
// point lies above the liquid's own depth there, over the depth, as under a jet or a drop; the
// largest speed over sqrt(g depth), of SPH.
Finding violent_motion(const std::vector<CaseAssessment>& cases, const FindingRow& row);

// The two highest peaks of the spectrum of the highest surface lie at the excitation and at twice
// it. Threshold: range of the relative difference in frequency.
Finding peaks_at_multiples(const std::vector<CaseAssessment>& cases, const FindingRow& row);

// The pressure of runs[0] against the record runs[1]: the lag of the forced tone, the rms
// difference of the two without their means, and the correlation of what is slower than a tenth of
// the impacts' period. Threshold: range of the lag [deg], of the difference, of the correlation.
Finding phase_against_record(const std::vector<CaseAssessment>& cases, const FindingRow& row);
Finding shape_against_record(const std::vector<CaseAssessment>& cases, const FindingRow& row);
Finding trend_against_record(const std::vector<CaseAssessment>& cases, const FindingRow& row);

// The difference of shape to the record runs[2], of runs[1] over that of runs[0]. Threshold: that
// of the quotient.
Finding nearer_to_record(const std::vector<CaseAssessment>& cases, const FindingRow& row);

// The rms difference of `quantity` between runs[0] and runs[1], filtered as the case's pressure.
// Threshold: range of the difference.
Finding difference_of_runs(const std::vector<CaseAssessment>& cases, const FindingRow& row);

// The pressure fields of runs[0] and runs[1] by their rms differences a and b to the finest
// interFoam run runs[2], which is not the truth here, only a common mesh: their own difference is
// between |a - b| and a + b. In units of density g depth, the mean over the snapshot times.
// Threshold: that of the difference.
Finding difference_of_fields(const std::vector<CaseAssessment>& cases, const FindingRow& row);

// The cells at the snapshot times that only one of the runs fills, runs[0] and the interFoam run
// runs[1], over the liquid's cells. Threshold: that of the share.
Finding surface_against_mesh(const std::vector<CaseAssessment>& cases, const FindingRow& row);

// The impacts of runs[0] against the published ones. Thresholds: largest delay over the period;
// range of the plateau's relative error; range of a peak's percentile among the repeats [%], its
// range in their standard deviations where the table of the repeats is not supplied, largest number
// of peaks outside.
Finding impact_times(const std::vector<CaseAssessment>& cases, const FindingRow& row);
Finding plateau_against_published(const std::vector<CaseAssessment>& cases, const FindingRow& row);
Finding peaks_among_repeats(const std::vector<CaseAssessment>& cases, const FindingRow& row);

// Fixed against moving boundary particles; runs are pairs, first the moving then the fixed: the
// runs that finish, the noise on the plateau and the wall crossings. Threshold: largest ratio of
// fixed to moving that counts as smaller. A difference of the crossings must also exceed the
// scatter of such counts.
Finding fixed_more_stable(const std::vector<CaseAssessment>& cases, const FindingRow& row);

// The change of the impacts from a coarse to a fine spacing: the rms over the impacts of the
// difference of ensemble means of log(peak), and of the time over the period. Runs: moving coarse,
// moving fine, fixed coarse, fixed fine, each an ensemble. Threshold: that of the moving change
// over the fixed one, for peaks and for times alike.
Finding fixed_changes_less(const std::vector<CaseAssessment>& cases, const FindingRow& row);

}  // namespace evidence
}  // namespace slosh
