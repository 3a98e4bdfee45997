// The metrics of an ensemble's impacts. Against the published impacts (impact_metrics.hpp) it is
// the median over the members with its interval (median_interval.hpp), as one member that spray
// strikes early, or whose peak is high, moves the mean and widens its interval without bound.
// Against the repeats of the experiment (peak_comparison.hpp) one peak of each member is the
// sample, of the pressure that the row names. The experiment's peaks are unfiltered; a row on the
// filtered pressure compares with them as they are, and its candidate's peaks are lower.
#pragma once

#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {

// The metric of a row, from the pressures of all members of its candidate; NaN where the impact
// does not occur in one of them: that ensemble has not the distribution of an experiment in which
// it always occurs. The half width of an arrival is at most a quarter of the impacts' period,
// within which it is sought. Throws what impact_metric() throws; for a metric against the repeats
// ComparisonError for fewer members than fewest_repeats, and what repeated_peaks(), peak_in() and
// peak_metric() throw.
Estimate repeated_impact_metric(const GateRow& row, const std::vector<const TimeSeries*>& pressures,
                                const TimeSeries* record, const CaseDefinition& definition);

}  // namespace slosh
