// The value of a gate row's metric: of one comparison, or the mean over an ensemble's comparisons.
#pragma once

#include <string>
#include <vector>

#include "verification/gate/gate_evidence.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {

// The value of a row that was not measured.
inline constexpr Estimate no_value{not_a_number, not_a_number};

// The metric of the row's candidate in the metric's unit. Where the candidate or the reference is
// an ensemble, this is the mean over all pairs of their members with the interval of
// ensemble_mean.hpp, which replaces the intervals of single histories. Metrics of impacts are the
// median over the ensemble or are of it as one sample (repeated_impacts.hpp); a cost has neither.
// Throws what the functions of the evidence throw, and ComparisonError where the row's unit is not
// the metric's.
Estimate measured(const GateRow& row, const GateEvidence& evidence);

// "the reference has no sample between 3 and 3.5 s, where the candidate departs by ..."
std::string unseen_text(const UnseenInterval& unseen, const std::string& unit);

struct Peak {
  double magnitude, time;
};

// The largest magnitude of a series and its time [s]; NaN where a value is NaN or there is none.
Peak largest_of(const TimeSeries& series);

// Half of the window: a value of less of it says little of the rest.
inline constexpr double least_coverage = 0.5;

// Tells, of the worst of an ensemble's pairs, unseen_text() of a metric of the whole histories (the
// modes of each series are fitted to its own samples), doubts_of_readings(), steps of more than a
// tenth of the row's bounds, bounds that a candidate of nothing meets, and the share of the window
// that the samples cover where that is not all; and the same of a run to improve on. Throws what
// measured() throws, and ComparisonError where they cover less than least_coverage.
RowDoubts doubts_of_samples(const GateRow& row, const GateEvidence& evidence);

// Whether the row is judged on the mean or the median over an ensemble, its candidate or its
// reference.
bool is_of_ensembles(const GateRow& row, const GateEvidence& evidence);
// The metric of each member of the candidate (outer index) against each member of the reference
// (inner index). Throws what measured() throws.
std::vector<std::vector<Estimate>> measured_pairs(const GateRow& row, const GateEvidence& evidence);

// The standard deviation of the members' series about their mean, in the unit of the row's metric,
// where that is the magnitude of a difference (ensemble_mean.hpp): of their differences' rms over
// the reference's deviation. Zero for any other metric, as for a largest magnitude, which is no
// difference and whose peaks may come at other times in each repeat, and for a single member.
// Throws what `comparison` throws.
double spread_of_series(const GateRow& row, const std::vector<std::string>& members,
                        const FindComparison& comparison);

// The run alone where the evidence has no ensembles.
EnsembleOfRun ensemble_of(const std::string& run, const GateEvidence& evidence);

// One member without a name, and exact, where the row has no reference.
EnsembleOfRun reference_of(const GateRow& row, const GateEvidence& evidence);

}  // namespace slosh
