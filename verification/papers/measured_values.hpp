// What claims are decided by: a campaign's results by the names of cases and runs, and the numbers
// of one run, one for each member of an ensemble. Throws std::runtime_error where something is
// missing, with a message that a claim can repeat.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/metrics/ensemble_mean.hpp"
#include "verification/papers/paper.hpp"

namespace slosh {

// find_case() returns null where the campaign has no such case; case_named() throws.
const CaseAssessment* find_case(const std::vector<CaseAssessment>& cases, const std::string& name);
const CaseAssessment& case_named(const std::vector<CaseAssessment>& cases, const std::string& name);

// Throws where the case declares no such run or the run has no result; the message says how it
// ended.
const RunResult& standing_result(const CaseAssessment& assessment, const std::string& run);

// Throws where the run left no such number, or one that is not finite.
double diagnostic_of(const CaseAssessment& assessment, const std::string& run,
                     const std::string& name);

// "interfoam_50x50 (mean of 4 repeats)", or the name of a single run.
std::string name_of_members(const CaseAssessment& assessment, const std::string& run);

// Returns the elevation or the highest surface at the case's first gauge: "elevation@right". Throws
// where the case has no gauge.
std::string at_first_gauge(const CaseDefinition& definition, const std::string& kind);

inline TimeWindow comparison_window(const CaseDefinition& definition) {
  return {definition.window_begin, definition.window_end};
}

// Returns the first pressure that the case filters, "wall_pressure@B/filtered", and its cutoff
// [Hz]. Throws where the case filters none.
std::pair<std::string, double> filtered_gauge(const CaseDefinition& definition);

// The mean of the larger less that of the smaller with its 95 % interval; half width 0 for single
// ones. Throws std::invalid_argument where one is empty.
Estimate difference_of_members(const std::vector<double>& larger,
                               const std::vector<double>& smaller, SingleSide single);

// The same of the geometric means, numbers above zero, as a ratio with the wider side of its
// interval.
Estimate ratio_of_members(const std::vector<double>& larger, const std::vector<double>& smaller,
                          SingleSide single = SingleSide::exact);

// The spectrum of the highest surface elevation at a surging tank's first gauge over the comparison
// window, as in Li et al. 2010: its peaks at the excitation frequency and at twice that.
struct SurfaceSpectrum {
  double excitation;                 // [Hz]
  std::array<SpectralPeak, 2> peak;  // nearest to one and two times that; NaN where there is none
  bool highest;                      // whether these are the two highest peaks of the spectrum

  double ratio() const { return peak[0].power / peak[1].power; }
};
SurfaceSpectrum surface_spectrum(const CaseAssessment& assessment, const std::string& run);

// The mean frequency of a peak over members with its interval [Hz] (mean_of_members()), or "none in
// 2 of 8" where members have no such peak.
std::string frequency_text(const std::vector<double>& members);

// A momentum is a magnitude that Li et al. do not define. Two are recorded, by the momentum P and
// the kinetic energy K of a liquid of mass M, and they bound sum m |v| at each time by the triangle
// inequality and that of Cauchy and Schwarz [kg/s]:
//   |P| <= sum m |v| <= sqrt(2 M K)
// Throws std::runtime_error where the times of momentum and energy differ.
std::pair<TimeSeries, TimeSeries> momentum_magnitudes(const RunResult& result,
                                                      const CaseDefinition& definition);

// By the smaller and by the larger of two magnitudes; equal where there is one.
struct Readings {
  double small, large;
};

// One for each member of the ensemble that the run begins. NaN where an impact or a peak of the
// spectrum does not exist.
std::vector<Readings> measured(const CaseAssessment& assessment, const std::string& run,
                               const Measured& what);
std::vector<double> numbers(const std::vector<Readings>& members,
                            double Readings::*which = &Readings::small);

// The difference of two time series over a window: rms(one - other) / rms(other - its mean), at the
// other's times within the window. Throws ComparisonError as cut_to_window() does.
struct HistoryDifference {
  double with_means;
  double without_means;  // the mean of each at those times is subtracted first
  double offset;         // mean of the other minus mean of the one, in their unit
};
HistoryDifference difference(const TimeSeries& one, const TimeSeries& other, TimeWindow window);

// The third standardised moment over the window.
double skewness(const TimeSeries& series, TimeWindow window);

// The lag of a tone of known frequency [rad/s] in one series behind the other [deg], and its
// amplitude in the one over that in the other, each with its 95 % interval: least squares of a mean
// and one tone at the other's times. Meant for a record too sparse for harmonic_fit.hpp.
struct ToneDifference {
  Estimate lag_degrees, amplitude_ratio;
};
ToneDifference tone_difference(const TimeSeries& one, const TimeSeries& other, TimeWindow window,
                               double angular_frequency);

}  // namespace slosh
