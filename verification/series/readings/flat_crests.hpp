// Crests that are cut off, as by the end of a sensor's range; of troughs ask the negative series.
//
// Three readings or more within a band of one value, with a descent on both sides, are a crest that
// is cut off where they fall by less inside than a round crest would. The parabola through both
// edges of a flat of length T falls from its own crest by h inside and by 3 h more within T / 2
// outside, so that the flat hides h = drop / 3; its fall inside is that of the parabola through its
// readings, by least squares, plus 2.5 standard errors of the noise, and the band of fewer than six
// readings or one step of the sensor at least. A sine falls by 1 to 1.3 times h, a trough like x^4
// by 0.2 h. Bands of 0.1 to 8 % of the range are tried, for noise. A flat hides 1.5 % of the range
// (3 % of a sine's amplitude) or more. It is told
// - at the highest value, where the sum over all crests that reach the band falls by a fifth of
//   what it hides or less;
// - at another value, as where the sensor's range was switched or a filter overshoots by one or two
//   samples at an edge, where four crests or more, of five readings or more each, lie in one band
//   1.5 % of the range or more below the highest value, and the sum over all crests there falls by
//   a 25th of what it hides or less. The nearer half outside has two fifths of the drop or more
//   there, which a smooth crest with a broad top does not have.
// A crest that is turned over at a level, |x - c|, is told where a polynomial describes it much
// better once it is turned back.
// Of 4800 waves of 40 s that are not cut, with noise of 0 to 1 % of the range and in no steps or 10
// to 98, five are told, and of 19200 more of twelve shapes none is told below the highest value.
// Noise of 0.2 % shows a crest that is cut by 6 % of the amplitude, that of 0.5 % one by 20 %, that
// of 1 % one by 30 %; below the highest value noise of 0.05 % shows a cut by 10 %, that of 0.2 %
// one by 30 % (sensor_statistics_test.cpp, sensor_limits_test.cpp).
#pragma once

#include <cstddef>
#include <optional>

#include "verification/series/time_series.hpp"

namespace slosh {

struct FlatExtreme {
  double value;       // the median of its readings, in the series' unit
  double begin, end;  // of the flat that hides most [s]
  double hidden;      // the height cut off there
};

inline constexpr std::size_t fewest_in_flat = 3;
inline constexpr double least_hidden = 0.015;  // of the range

// Returns the flat crest that hides most inside of the window; nullopt where there is none. `step`
// is that of the sensor, 0 where it has none: within it nothing is known of a fall.
std::optional<FlatExtreme> flat_crest(const TimeSeries& series, double step, TimeWindow window);

}  // namespace slosh
