// The peaks of an ensemble against those of the repeats of an experiment: two samples of one
// impact. A single impact cannot be predicted, its distribution can.
//   peak_mean_p_value   Welch's test of equal means (two_sample_statistics.hpp)
//   peak_ks_p_value     Kolmogorov-Smirnov, its p-value by permutation (permutation_test.hpp)
//   peak_ad_p_value     Anderson-Darling, likewise
//   peak_median_error   the ratio of the medians, less 1
// The last has a bootstrap interval (bootstrap_interval.hpp). A p-value above 5 % does not
// show that two distributions are equal, but only that these samples do not tell them apart: of a
// candidate whose peaks are all 25 % too high, with a deviation of 30 %, 20 repeats against 102
// have p < 5 % in 79 % (mean), 73 % (Kolmogorov-Smirnov) and 82 % (Anderson-Darling) of all cases,
// 40 repeats in 96, 92 and 96 %; of two samples of one distribution they have it in 5.3, 4.7 and
// 4.7 % (4000 pairs of lognormal samples). Welch's test supposes normal means: of the skewed peaks
// of SPHERIC benchmark 10 themselves it rejects 6 to 7 %, the other two 4 to 6 %. Of fewer repeats
// nothing is said.
#pragma once

#include <string>
#include <vector>

#include "verification/case/metric_table.hpp"
#include "verification/series/distribution.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {

inline constexpr std::size_t fewest_repeats = 20;

// An estimate, and its interval where that is not symmetric.
struct SampleFigure {
  Estimate value;
  Interval interval;
};

// All are of the unit 1.
struct PeakComparison {
  Estimate mean_p, ks_p, ad_p;
  SampleFigure median_error;
};

// Throws ComparisonError for fewer than `fewest_repeats` peaks on one of the sides, and where the
// experiment's mean or its median is not above zero.
PeakComparison compare_peaks(const Distribution& candidate, const Distribution& experiment);

// One of these metrics. Throws ComparisonError as compare_peaks() does, and std::logic_error for
// another metric.
Estimate peak_metric(Metric metric, const Distribution& candidate, const Distribution& experiment);

}  // namespace slosh
