// Eight particles side by side: the number type of the pair loops. Every function here exists for
// plain doubles too, so that a formula is written once.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>

namespace slosh::sph {

inline constexpr std::size_t lane_count = 8;
using Lanes = double __attribute__((vector_size(lane_count * sizeof(double))));

inline double square_root(double a) { return std::sqrt(a); }
inline Lanes square_root(Lanes a) {
  Lanes root;
  for (std::size_t lane = 0; lane < lane_count; ++lane) root[lane] = std::sqrt(a[lane]);
  return root;
}

// The larger of a and `bound`; `bound` where a is no number.
inline double at_least(double bound, double a) { return a > bound ? a : bound; }
inline Lanes at_least(double bound, Lanes a) {
  const Lanes bounds = bound - Lanes{};
  return a > bounds ? a : bounds;
}

// The smaller of a and b; b where a is no number.
inline double at_most(double a, double b) { return a < b ? a : b; }
inline Lanes at_most(Lanes a, Lanes b) { return a < b ? a : b; }

inline double negative_part(double a) { return a < 0.0 ? a : 0.0; }
inline Lanes negative_part(Lanes a) { return a < Lanes{} ? a : Lanes{}; }

// Eight consecutive doubles from `begin`.
inline Lanes load(const double* begin) {
  Lanes lanes;
  std::memcpy(&lanes, begin, sizeof lanes);
  return lanes;
}

// The first `count` lanes to `begin`.
inline void store(double* begin, Lanes lanes, std::size_t count) {
  if (count == lane_count)
    std::memcpy(begin, &lanes, sizeof lanes);
  else
    for (std::size_t lane = 0; lane < count; ++lane) begin[lane] = lanes[lane];
}

}  // namespace slosh::sph
