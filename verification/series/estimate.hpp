// A measured value with its interval, and what stands where there is none.
#pragma once

#include <limits>

namespace slosh {

// A value and half the width of its 95 % confidence interval, in the same unit.
struct Estimate {
  double value;
  double half_width;
};

inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace slosh
