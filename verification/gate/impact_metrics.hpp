// A run's impacts compared with the published ones of its case: the arrival, the peak and the
// impulse of each impact, and the height of the plateau after it. An impact's peak is sought within
// a quarter of a period of its published time (impact_peaks.hpp), in the whole history and not in
// the comparison's window alone.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/series/distribution.hpp"
#include "verification/series/impact_peaks.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {

// The user has not supplied something that a metric needs; what() names it.
struct NotSuppliedError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// All functions throw ComparisonError where the case has no [impacts].

// One peak for each published time; nullopt where that impact does not occur. Throws
// ComparisonError as impact_peaks() does.
std::vector<std::optional<ImpactPeak>> impacts_in(const TimeSeries& pressure,
                                                  const CaseDefinition& definition);

// The run's mean over the time of the published plateau, divided by the published value, less 1.
// Throws ComparisonError as plateau_mean() does.
double plateau_error(const TimeSeries& pressure, const CaseDefinition& definition);

// The peaks of the n-th impact in all repeats [Pa], n from 0. Throws NotSuppliedError.
Distribution repeated_peaks(const CaseDefinition& definition, std::size_t n);

// The time that the highest sample of the n-th impact should have [s]; reports tell the difference,
// no metric does. In the unfiltered pressure this is the published time. The filter moves the
// peaks, so that in the filtered pressure it is the time of the peak in `record`, the record's
// series of the same name filtered alike; nullptr where there is none. Throws NotSuppliedError
// where the record is needed and missing, and ComparisonError where it does not have the impact.
double expected_time(std::size_t n, const TimeSeries& pressure, const TimeSeries* record,
                     const CaseDefinition& definition);

// The time [s] at which the pressure comes to the declared share of the n-th published peak and
// holds it, n from 0; nullopt where it does not. Of a filtered pressure too, the published arrival
// is that of the unfiltered record: a filter of zero phase moves the middle of a rise by less than
// its own width, 0.13 / cutoff. Throws ComparisonError where none is published, and as
// arrival_time() does.
std::optional<double> arrival_in(const TimeSeries& pressure, std::size_t n,
                                 const CaseDefinition& definition);

// The impulse [Pa s] of the n-th impact over the declared time from its arrival on; nullopt where
// it does not arrive. Throws ComparisonError where none is published, and as impulse() does.
std::optional<double> impulse_in(const TimeSeries& pressure, std::size_t n,
                                 const CaseDefinition& definition);

// What is told of one impact; nullopt for what does not occur or is not published.
struct ImpactNumbers {
  std::optional<ImpactPeak> peak = {};
  std::optional<double> rise_time = {}, arrival = {};  // [s]
  std::optional<double> impulse = {};                  // [Pa s]
};

// The numbers of all impacts. Throws ComparisonError as the functions above do.
std::vector<ImpactNumbers> impact_numbers(const TimeSeries& pressure,
                                          const CaseDefinition& definition);

// Returns 0 for "impact_1", 1 for "impact_2", ... Throws ComparisonError for an impact that the
// case does not have.
std::size_t impact_number(const std::string& mode, const CaseDefinition& definition);

// The peak [Pa] of the n-th impact; nullopt where the impact does not occur. Throws ComparisonError
// as impacts_in() does, and where it does not occur in the record either.
std::optional<ImpactPeak> peak_in(const TimeSeries& pressure, std::size_t n,
                                  const TimeSeries* record, const CaseDefinition& definition);

// The metric in its own unit; NaN where the mode's impact does not occur in the candidate's
// pressure. Throws what the functions above throw, and ComparisonError where the impact does not
// occur in the record either.
double impact_metric(Metric metric, const std::string& mode, const TimeSeries& pressure,
                     const TimeSeries* record, const CaseDefinition& definition);

}  // namespace slosh
