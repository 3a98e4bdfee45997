// The p-value of a statistic of two samples without a formula for its distribution, ties included:
// if both are of one distribution, every division of their values into two samples of these sizes
// is equally likely. Of B random divisions, b have a statistic as large as the samples' or larger:
//   p = (b + 1) / (B + 1)
// (Phipson & Smyth 2010, Stat. Appl. Genet. Mol. Biol. 9:39), a value that is never zero, so that
// the test rejects at the level a in at most a of all cases. The divisions are drawn by a seed: the
// same samples have the same p-value everywhere.
#pragma once

#include <functional>

#include "verification/gate/distributions/seeded_draws.hpp"
#include "verification/gate/distributions/two_sample_statistics.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {

// A p-value near 5 % is known to 0.4 %.
inline constexpr SeededTrials permutations{9999, 1987};

using TwoSampleStatistic =
    std::function<double(const PooledSamples& pooled, const std::vector<int>& counts)>;

double kolmogorov_smirnov_statistic(const PooledSamples& pooled, const std::vector<int>& counts);
double anderson_darling_statistic(const PooledSamples& pooled, const std::vector<int>& counts);

// The p-value, with the half width of the 95 % interval that its finite number of divisions leaves
// (Wilson 1927, J. Am. Stat. Assoc. 22:209: that of a proportion, to its farther end).
Estimate permutation_p_value(const Distribution& one, const Distribution& other,
                             const TwoSampleStatistic& statistic,
                             const SeededTrials& divisions = permutations);

}  // namespace slosh
