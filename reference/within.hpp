// Where and when a solution in a rectangular tank is defined: in the liquid at rest, x from the
// tank's centre and z from the still surface, and while the motion lasts. Rounding apart; what lies
// outside, and NaN, throws std::invalid_argument.
#pragma once

#include <algorithm>
#include <cmath>

#include "reference/linear_surge.hpp"
#include "reference/require.hpp"

namespace slosh::reference {

// By how much a position or a time may lie outside, relative to the tank or the record.
inline constexpr double rounding = 1e-9;

inline void require_within(const Tank& tank, std::string_view where, double x) {
  require(std::abs(x) <= (0.5 + rounding) * tank.length, where, "x", x,
          fmt::format("a position within {} m of the tank's centre", tank.length / 2));
}

inline void require_within(const Tank& tank, std::string_view where, double x, double z) {
  require_within(tank, where, x);
  require(
      z <= rounding * tank.fill_depth && z >= -(1 + rounding) * tank.fill_depth, where, "z", z,
      fmt::format("a height from {} m (the bottom) to 0 (the still surface)", -tank.fill_depth));
}

// The time t, which may not lie beyond `last`.
inline double time_within(std::string_view where, double t, double last) {
  require(t >= 0 && t <= last + rounding * last, where, "time", t,
          fmt::format("a time from 0 to {} s", last));
  return std::min(t, last);
}

}  // namespace slosh::reference
