// Stretches that a gauge has not read: it held its last reading, read one value, or the gap was
// filled by a straight line, in noise that goes on.
//
// Three to ten samples or more, of which each is the mean of up to 2^k of the series', are lost
// where the curve through the samples on both sides is interrupted by a straight line
// (interruption.hpp): where
// - they leave the curve by 6 times what a quarter of the stretches of this length leave theirs
//   by, and by twice what the interrupted description leaves of a sample,
// - it leaves of all samples less than half of what one curve does, and two thirds of what two
//   curves do that part at one end, by 20 and 10 times the variance of the noise at least,
// - three straight lines leave half of what it does or more, and the curve stays near to the range
//   of the samples on both sides.
// Four of them or more are told, where the series is off by 1 % of its mean departure from its mean
// in the mean; none counts for more than two of median size. Fronts, plateaus and impacts of a few
// instants are not. What was measured: sensor_statistics_test.cpp.
#pragma once

#include <cstddef>
#include <optional>

#include "verification/series/time_series.hpp"

namespace slosh {

struct LostStretches {
  std::size_t count;
  double begin, end;                 // of the one that is off most [s]
  double hidden;                     // by which a sample of the series is off in the mean
  std::optional<double> value = {};  // where all are at one value
};

// Of more than 100000 samples means of neighbours are asked. Windows in which the sample interval
// changes by half are left out.
std::optional<LostStretches> lost_stretches(const TimeSeries& series);

}  // namespace slosh
