// The vector types of the pair loops, whose lanes hold one particle each. The functions of formulas
// exist for plain doubles too, so that a formula is written once.
#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace slosh::sph {

inline constexpr std::size_t lane_count = 8;
using Lanes = double __attribute__((vector_size(lane_count * sizeof(double))));
// Vectors that fit a register of AVX2 and of the plain instructions. The compiler splits wider
// ones, into single lanes for comparisons.
using FourLanes = double __attribute__((vector_size(4 * sizeof(double))));
using TwoLanes = double __attribute__((vector_size(2 * sizeof(double))));

template <class Number>
concept Vector = std::same_as<Number, Lanes> || std::same_as<Number, FourLanes> ||
    std::same_as<Number, TwoLanes>;
template <Vector Number>
inline constexpr std::size_t lanes_of = sizeof(Number) / sizeof(double);

// 1/sqrt(a) and 1/a of a positive number up to 1e300, and the square root, to a few units of the
// last place. The square root and the division of AVX-512 take several times as long as its
// estimates and the products that refine them: from the error e of 2^-13 to the order of e^4.
inline double square_root(double a) { return std::sqrt(a); }
inline double inverse_square_root(double a) { return 1.0 / std::sqrt(a); }
inline double reciprocal(double a) { return 1.0 / a; }
template <Vector Number>
Number square_root(Number a) {
  Number root;
  for (std::size_t lane = 0; lane < lanes_of<Number>; ++lane) root[lane] = std::sqrt(a[lane]);
  return root;
}
template <Vector Number>
Number inverse_square_root(Number a) {
  return 1.0 / square_root(a);
}
template <Vector Number>
Number reciprocal(Number a) {
  return 1.0 / a;
}
#if defined(__x86_64__) && !defined(SLOSH_PLAIN_LOOPS)
[[gnu::target("arch=x86-64-v4")]] inline Lanes estimate_of_inverse_square_root(Lanes a) {
  return __builtin_ia32_rsqrt14pd512_mask(a, Lanes{}, 0xff);
}
[[gnu::target("arch=x86-64-v4")]] inline Lanes estimate_of_reciprocal(Lanes a) {
  return __builtin_ia32_rcp14pd512_mask(a, Lanes{}, 0xff);
}
inline Lanes inverse_square_root(Lanes a) {
  const Lanes y = estimate_of_inverse_square_root(a), e = 1.0 - a * y * y;
  return y + y * e * (0.5 + e * (0.375 + e * 0.3125));
}
inline Lanes square_root(Lanes a) {
  const Lanes bounded = a + 1e-60;  // for a = 0
  return bounded * inverse_square_root(bounded);
}
inline Lanes reciprocal(Lanes a) {
  const Lanes y = estimate_of_reciprocal(a), e = 1.0 - a * y;
  return y + y * e * (1.0 + e * (1.0 + e));
}
#endif

// Comparisons as integers order doubles too, unless both are negative. AVX-512 has a larger and a
// smaller of integers in one instruction; the compiler makes two of those of doubles, for the sake
// of NaN.
using IntegerLanes = std::int64_t __attribute__((vector_size(sizeof(Lanes))));
inline Lanes larger_of_integers(Lanes a, Lanes b) {
  const IntegerLanes i = reinterpret_cast<IntegerLanes>(a), j = reinterpret_cast<IntegerLanes>(b);
  return reinterpret_cast<Lanes>(i > j ? i : j);
}
inline Lanes smaller_of_integers(Lanes a, Lanes b) {
  const IntegerLanes i = reinterpret_cast<IntegerLanes>(a), j = reinterpret_cast<IntegerLanes>(b);
  return reinterpret_cast<Lanes>(i < j ? i : j);
}

// Returns the larger of a and `bound`, which is not negative; either of them where a is NaN.
inline double at_least(double bound, double a) { return a > bound ? a : bound; }
template <Vector Number>
Number at_least(double bound, Number a) {
  const Number bounds = bound - Number{};
  if constexpr (std::same_as<Number, Lanes>) return larger_of_integers(a, bounds);
  return a > bounds ? a : bounds;
}

// Returns the smaller of a and b; b where a is NaN.
template <Vector Number>
Number at_most(Number a, Number b) {
  return a < b ? a : b;
}

// Returns a where it is negative, and 0 elsewhere.
inline double negative_part(double a) { return a < 0.0 ? a : 0.0; }
template <Vector Number>
Number negative_part(Number a) {
  if constexpr (std::same_as<Number, Lanes>) return smaller_of_integers(a, Number{});
  return a < Number{} ? a : Number{};
}

// Loads consecutive doubles from `begin`.
template <Vector Number = Lanes>
Number load(const double* begin) {
  Number lanes;
  std::memcpy(&lanes, begin, sizeof lanes);
  return lanes;
}

// Loads consecutive floats from `begin`.
template <Vector Number>
Number load(const float* begin) {
  Number lanes;
  for (std::size_t lane = 0; lane < lanes_of<Number>; ++lane) lanes[lane] = begin[lane];
  return lanes;
}

// Stores the first `count` lanes at `begin`.
template <Vector Number>
void store(double* begin, Number lanes, std::size_t count) {
  if (count >= lanes_of<Number>)
    std::memcpy(begin, &lanes, sizeof lanes);
  else
    for (std::size_t lane = 0; lane < count; ++lane) begin[lane] = lanes[lane];
}

}  // namespace slosh::sph
