// The types that all metrics share: a time series, a window of time, a value with its confidence
// interval, and the error where no comparison is possible.
#pragma once

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace slosh {

// A comparison is not possible: no overlap, a truncated or non-finite series, a window too short
// for the modes.
struct ComparisonError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A sampled quantity: the output of every solver, the input of every metric and figure.
struct TimeSeries {
  std::string name;           // "elevation@right", "force_x", ...
  std::string unit;           // SI, as written in the result file: "m", "N/m", "J/m", "Pa"
  std::vector<double> time;   // [s], strictly increasing
  std::vector<double> value;  // same length as time
};

// A closed interval of time [s].
struct TimeWindow {
  double begin;
  double end;
};

// A value and half the width of its 95 % confidence interval, in the same unit.
struct Estimate {
  double value;
  double half_width;
};

inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace slosh
