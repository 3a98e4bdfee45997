// How a reference solution refuses an argument: the error names the function, the argument, its
// value and what was expected.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include "reference/tank.hpp"

namespace slosh::reference {

// Throws std::invalid_argument unless `holds`. Callers write the condition so that NaN fails it.
template <class Value>
void require(bool holds, std::string_view where, std::string_view key, Value value,
             std::string_view expected) {
  if (!holds) {
    throw std::invalid_argument(
        fmt::format("{}: {} = {}, expected {}", where, key, value, expected));
  }
}

// A position may lie outside the tank, and a time after the end, by this share of the tank's size
// or of the duration.
inline constexpr double rounding = 1e-9;

// The following throw std::invalid_argument for NaN and for an x [m] from the tank's centre or a z
// [m] from the still surface that lies outside the liquid at rest.
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

// Returns the time t [s], reduced to `last` where it exceeds `last` by rounding. Throws
// std::invalid_argument for NaN and for a time before 0 or after `last`.
inline double time_within(std::string_view where, double t, double last) {
  require(t >= 0 && t <= last + rounding * last, where, "time", t,
          fmt::format("a time from 0 to {} s", last));
  return std::min(t, last);
}

}  // namespace slosh::reference
