// A metric of flows whose histories small disturbances decide: its mean over the repeats of both
// sides, and the 95 % interval that the spread of these repeats alone gives. With m_ij the metric
// of candidate i (of n_c) against reference j (of n_r), a_i its mean over j and b_j its mean over
// i:
//   m = sum m_ij / (n_c n_r),   u^2 = s_a^2 / n_c + s_b^2 / n_r,   half width = t_(0.975, nu) u,
//   nu = u^4 / ((s_a^2 / n_c)^2 / (n_c - 1) + (s_b^2 / n_r)^2 / (n_r - 1))
// with s the standard deviations (Welch 1947, Biometrika 34:28; Satterthwaite 1946, Biometrics
// Bull. 2:110). It holds where the metric is a sum of what the two sides add, as the logarithm of a
// ratio is and a small error nearly.
#pragma once

#include <vector>

#include "verification/fits/harmonic_fit.hpp"

namespace slosh {

// A side of one run has no spread of its own. It is exact where disturbances do not decide it
// (theory, a record). Any other is taken to spread as the other side does, u^2 = s^2 (1 + 1 / n) of
// n - 1 degrees of freedom (the interval that holds one more run), and as its own history says,
// whose mean half width over the pairs is added in quadrature: the other side, of another method,
// may spread less.
enum class SingleSide { exact, one_of_many };

// pairs[i][j] of candidate i and reference j with the interval of its own histories; as many in
// each row, one side at least with two or more. NaN among them gives NaN. Throws
// std::invalid_argument of a single pair.
Estimate ensemble_mean(const std::vector<std::vector<Estimate>>& pairs, SingleSide single);

}  // namespace slosh
