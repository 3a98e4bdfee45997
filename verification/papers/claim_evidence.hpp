// What claims are decided by: a campaign's results, by the names of cases and runs, and a few
// measures of them. What is not there throws std::runtime_error in words that a claim can repeat.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "verification/assessment/case_assessment.hpp"

namespace slosh {

// Null where the campaign has no such case; the other throws.
const CaseAssessment* find_case(const std::vector<CaseAssessment>& cases, const std::string& name);
const CaseAssessment& case_named(const std::vector<CaseAssessment>& cases, const std::string& name);

// Throws where the case declares no such run or it left no result, with how it ended.
const RunResult& standing_result(const CaseAssessment& assessment, const std::string& run);

// The case's first gauge's elevation or highest surface: "elevation@right". Throws where the case
// has none.
std::string at_first_gauge(const CaseDefinition& definition, const std::string& kind);

TimeWindow comparison_window(const CaseDefinition& definition);

// A gauge whose pressure the case filters: "wall_pressure@B/filtered" and its cutoff [Hz]. Throws
// where the case has none.
std::pair<std::string, double> filtered_gauge(const CaseDefinition& definition);

// How far two histories are apart over a window: rms(one - other) / rms(other - its mean), at the
// other's times within the window; both are checked as cut_to_window() does.
struct HistoryDifference {
  double as_it_is;
  double without_means;  // each freed of its mean at those times first
  double offset;         // mean of the other less that of the one, in their unit
};
HistoryDifference difference(const TimeSeries& one, const TimeSeries& other, TimeWindow window);

// The third standardised moment over the window.
double skewness(const TimeSeries& series, TimeWindow window);

// How late the tone of a known frequency [rad/s] is in one series against the other [deg], and its
// amplitude in one over that in the other, each with its 95 % interval: least squares of a mean and
// one tone at the other's times. For a record too sparse for harmonic_fit.hpp.
struct ToneDifference {
  Estimate lag_degrees, amplitude_ratio;
};
ToneDifference tone_difference(const TimeSeries& one, const TimeSeries& other, TimeWindow window,
                               double angular_frequency);

}  // namespace slosh
