// The mean of a metric over an ensemble, for flows whose time series depend on small disturbances:
// the mean over the repeats of both sides, with the 95 % interval that the scatter of these repeats
// gives. With m_ij the metric of candidate i (of n_c) against reference j (of n_r), a_i its mean
// over j and b_j its mean over i:
//   m = sum m_ij / (n_c n_r),   u^2 = s_a^2 / n_c + s_b^2 / n_r,   half width = t_(0.975, nu) u,
//   nu = u^4 / ((s_a^2 / n_c)^2 / (n_c - 1) + (s_b^2 / n_r)^2 / (n_r - 1))
// with s the standard deviations (Welch 1947, Biometrika 34:28; Satterthwaite 1946, Biometrics
// Bull. 2:110). Valid where the metric is a sum of one term per side, as the logarithm of a ratio
// is and, nearly, a small error. The magnitude of a difference is no such sum: runs that are 15 %
// too high and 15 % too low have the same one. Its spread is taken from the series, as |m_i - m_j|
// is at most the magnitude of c_i - c_j:
//   s^2 >= sum over i < j of |c_i - c_j|^2 / (n (n - 1))
// Repeats that scatter by less than a tenth of their own intervals are one run, as copies of it
// are: the mean of these intervals is added in quadrature.
#pragma once

#include <vector>

#include "verification/series/time_series.hpp"

namespace slosh {

// How a side of one run counts, which shows no scatter of its own. It is `exact` where disturbances
// do not affect it (theory, a record). Otherwise (`one_of_many`) it is assumed to scatter as the
// other side does, u^2 = s^2 (1 + 1 / n) of n - 1 degrees of freedom (the interval that holds one
// more run). The mean half width of the pairs' own intervals is then added in quadrature, because
// the other side, of another method, may scatter less.
enum class SingleSide { exact, one_of_many };

// The least standard deviation of either side, where the metric is a magnitude.
struct LeastDeviations {
  double candidates = 0, references = 0;
};

// pairs[i][j] is the metric of candidate i and reference j with the interval of its own time
// series; all rows have the same length, and at least one side has two or more runs. A NaN among
// them gives NaN. Throws std::invalid_argument for a single pair.
Estimate ensemble_mean(const std::vector<std::vector<Estimate>>& pairs, SingleSide single,
                       const LeastDeviations& least = {});

// The mean of one number of each member with its 95 % interval, t_(0.975, n - 1) s / sqrt(n); half
// width 0 for a single number. Throws std::invalid_argument for none.
Estimate mean_of_members(const std::vector<double>& numbers);

}  // namespace slosh
