// A sampled quantity: what every solver leaves, every metric reads and every figure draws.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace slosh {

// Nothing can be compared: no overlap, a truncated or non-finite series, a window too short for the
// modes.
struct ComparisonError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

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

}  // namespace slosh
