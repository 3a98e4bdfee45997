// 95 % intervals of quantities that are computed from integrals over a whole window, by the
// delete-one-block jackknife (Kuensch 1989, Ann. Statist. 17:1217). With S_j the integrals over the
// j-th of K blocks and S their sum,
//   theta_j = f(S - S_j),   variance = (K - 1) / K sum_j (theta_j - mean theta)^2,
// half width = Student's t of K - 1 degrees of freedom at 97.5 % times the square root of the
// variance. The blocks are at least as long as the longest period, so that they are nearly
// independent: the interval covers the value in another window of the same flow. A transient has no
// such blocks.
#pragma once

#include <functional>
#include <vector>

#include "verification/series/time_series.hpp"

namespace slosh {

// Integrals over one block of residual^2, (reference - mean)^2, candidate^2, reference^2 and
// candidate times reference.
struct BlockIntegrals {
  double residual = 0, variation = 0, candidate = 0, reference = 0, product = 0;

  BlockIntegrals& operator+=(const BlockIntegrals& other);
};

inline constexpr int fewest_blocks = 3, most_blocks = 8;

// The number of whole periods in the duration [both s], at most most_blocks; 1 where it would be
// below fewest_blocks.
int block_count(double duration, double longest_period);

// The half width from the values theta_j that are left without one block each, of two or more.
double jackknife_half_width(const std::vector<double>& without);

// The value of `of` for the sum of all blocks, with its interval. A single block has a half width
// of zero: its interval is unknown.
Estimate block_jackknife(const std::vector<BlockIntegrals>& blocks,
                         const std::function<double(const BlockIntegrals&)>& of);

}  // namespace slosh
