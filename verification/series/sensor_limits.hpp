// What the readings of a sensor, or of a program that prints few digits, hide of a wave.
//
// Levels: where nine tenths of the values are read twice or more and all these lie on equal steps q
// of which fewer than a hundred reach from the lowest to the highest, a reading is off by up to
// q / 2. The amplitude A of a fitted sine is then off by up to 0.2 q sqrt(q / A): the quantised
// sine has the fundamental A + sum_m (2 q / (m pi)) (-1)^m J_1(2 pi m A / q), |J_1(x)| < sqrt(2 /
// (pi x)) (Fourier series of the staircase). A hundred steps, q = A / 50, hide 1 % of a crest and
// 0.06 % of an amplitude.
//
// Flats: three readings or more within a thousandth of the range of the highest (lowest) value,
// with a descent on both sides, are a crest that is cut off. A round crest hides as much by this as
// its readings differ. The parabola through both edges of a flat of length T falls from its own
// crest by h inside and by 3 h more within T / 2 outside, so that the flat hides h = drop / 3. A
// crest that is only read in steps has h <= 4 q / 3 by this, below 1.5 % of the range for a hundred
// steps: from there on, 3 % of a sine's amplitude, it is told.
#pragma once

#include <optional>

#include "verification/series/time_series.hpp"

namespace slosh {

struct FlatExtreme {
  double value;       // the highest or lowest, in the series' unit
  double begin, end;  // of the flat that hides most [s]
  double hidden;      // the height cut off there
};

struct SensorLimits {
  double range = 0;  // from the lowest to the highest value
  std::optional<double> step;
  std::optional<FlatExtreme> highest, lowest;
};

// Requires a series that cut_to_window() has checked. Of more than 20000 samples every k-th serves
// to find the levels.
SensorLimits sensor_limits(const TimeSeries& cut);

}  // namespace slosh
