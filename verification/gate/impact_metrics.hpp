// What sets a run's impacts apart from the published ones of its case: when each comes, how high
// the plateau behind it is, and where its peak falls among the peaks of the experiment's repeats,
// of which no two are alike. An impact's peak is sought within a quarter of the period of its
// published time (impact_peaks.hpp); the whole history counts, not the comparison's window.
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

// What a metric needs is not supplied: what() says what.
struct NotSuppliedError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// All of them throw ComparisonError where the case says nothing of impacts.

// One for each published time, none where that impact does not come. Throws ComparisonError as
// impact_peaks() does.
std::vector<std::optional<ImpactPeak>> impacts_in(const TimeSeries& pressure,
                                                  const CaseDefinition& definition);

// The run's mean over the published plateau's time, over the published value, less 1. Throws
// ComparisonError as plateau_mean() does.
double plateau_error(const TimeSeries& pressure, const CaseDefinition& definition);

// The peaks of the repeats' n-th impact, n from 0 [Pa]. Throws NotSuppliedError.
Distribution repeated_peaks(const CaseDefinition& definition, std::size_t n);

// When the n-th impact should come [s]. In the pressure as it is: as published. In the filtered
// pressure, whose peaks stand elsewhere: as in the record's, filtered alike. `record`: the record's
// series of the same name, null where there is none. Throws NotSuppliedError for want of it, and
// ComparisonError where the impact is not in it.
double expected_time(std::size_t n, const TimeSeries& pressure, const TimeSeries* record,
                     const CaseDefinition& definition);

// In the metric's unit; NaN where the mode's impact does not come in the candidate's pressure.
// Throws as those above, and ComparisonError where it does not come in the record's either.
double impact_metric(Metric metric, const std::string& mode, const TimeSeries& pressure,
                     const TimeSeries* record, const CaseDefinition& definition);

}  // namespace slosh
