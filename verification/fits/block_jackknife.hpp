// 95 % intervals of what is computed from integrals over a whole window, by the delete-one-block
// jackknife (Kuensch 1989, Ann. Statist. 17:1217): with S_j the integrals over the j-th of K blocks
// and S their sum,
//   theta_j = f(S - S_j),   variance = (K - 1) / K sum_j (theta_j - mean theta)^2,
// half width = Student's t of K - 1 degrees of freedom at 97.5 % times the root of it. The blocks
// are as long as the longest period or longer, so that they say nearly independent things of the
// window: how far the figure would be another in another window of the same flow. A transient has
// no such blocks.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "verification/fits/harmonic_fit.hpp"

namespace slosh {

// Integrals over one block of residual^2, (reference - mean)^2, candidate^2, reference^2 and
// candidate times reference.
struct BlockIntegrals {
  double residual = 0, variation = 0, candidate = 0, reference = 0, product = 0;

  BlockIntegrals& operator+=(const BlockIntegrals& other);
};

inline constexpr int fewest_blocks = 3, most_blocks = 8;

// As many blocks as there are of the period in the duration, at most most_blocks [both s]; 1 where
// there would be fewer than fewest_blocks.
int block_count(double duration, double longest_period);

// `of` whole sums. The half width of a single block is zero: none is known.
Estimate block_jackknife(const std::vector<BlockIntegrals>& blocks,
                         const std::function<double(const BlockIntegrals&)>& of);

}  // namespace slosh
