// The metrics of an ensemble's impacts against the repeats of the experiment
// (peak_comparison.hpp): one peak of each member is the sample, of the pressure that the row names.
// The experiment's peaks are unfiltered; a row on the filtered pressure compares with them as they
// are, and its candidate's peaks are lower.
#pragma once

#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {

// The metric of a row, from the pressures of all members of its candidate; NaN where the impact
// does not occur in one of them: that ensemble has not the distribution of an experiment in which
// it always occurs. Throws ComparisonError for fewer members than fewest_repeats, and what
// repeated_peaks(), peak_in() and peak_metric() throw.
Estimate repeated_impact_metric(const GateRow& row, const std::vector<const TimeSeries*>& pressures,
                                const TimeSeries* record, const CaseDefinition& definition);

}  // namespace slosh
