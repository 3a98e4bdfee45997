// What the readings of a sensor, or of a program that prints few digits, hide of a wave.
//
// Levels: where nine tenths of the values are read twice or more and all these lie on equal steps q
// of which fewer than a hundred reach from the lowest to the highest, a reading is off by up to
// q / 2. The amplitude A of a fitted sine is then off by up to 0.2 q sqrt(q / A): the quantised
// sine has the fundamental A + sum_m (2 q / (m pi)) (-1)^m J_1(2 pi m A / q), |J_1(x)| < sqrt(2 /
// (pi x)) (Fourier series of the staircase). A hundred steps, q = A / 50, hide 1 % of a crest and
// 0.06 % of an amplitude.
//
// Flats: flat_crests.hpp.
//
// Sparse readings: a program or a logger writes more samples than it has readings, and holds each
// reading or joins them by straight lines. A reading ends where the series leaves the line through
// its last two samples by more than 1e-5 of the range and 8 times what a quarter of the samples
// leave it by, which is noise. It counts where it lasts for more than one sample, as the next one
// does, which goes on where the series turned to. T is the median of their times. A held reading is
// off by half the jump to the next one in the mean. A line hides a crest of height T |change of
// slope| / 8. Either is told where its median, times the share of the time that such readings take,
// is 1.5 % of the range or more: a lag of 2.5 degrees, or 3 % of a sine's amplitude. A crest that
// is cut off and filtered afterwards is not seen.
//
// Isolated readings, as where an echo is lost: one or two samples, or more of one value, leave the
// line between their neighbours by a twentieth of the range or more, by 8 times what half the
// samples leave theirs by or more, and by 5 times what these neighbours leave theirs by or more.
// They are told where all samples are off by 1 % of the mean departure from the mean in the mean.
// Flats are sought without them. Lost stretches (lost_stretches.hpp) are sought where the readings
// are neither sparse nor isolated nor in steps, low samples (lost_share.hpp) where no doubt is.
#pragma once

#include <cstddef>
#include <optional>

#include "verification/series/readings/flat_crests.hpp"
#include "verification/series/readings/lost_stretches.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {

struct SparseReadings {
  bool held;        // otherwise joined by straight lines
  double interval;  // from reading to reading [s]
  double hidden;    // by which a held value is off in the mean, or a crest is cut off
};

struct IsolatedReadings {
  std::size_t count;
  double time;                       // of the one that leaves its neighbours most [s]
  double hidden;                     // by which a sample of the series is off in the mean
  bool above = false;                // their neighbours; else below
  std::optional<double> value = {};  // of two or more of one value
};

struct SensorLimits {
  double range = 0;  // from the lowest to the highest value
  std::optional<double> step;
  std::optional<FlatExtreme> highest, lowest;
  std::optional<SparseReadings> sparse = {};
  std::optional<IsolatedReadings> isolated = {};
  std::optional<LostStretches> lost = {};
  std::optional<double> roughness = {};  // of rough readings: that share of the deviation
  std::optional<double> growth = {};     // lost_share.hpp, where nothing else is told
};

// What the readings hide inside of the window. A window that holds a part of a crest or few
// readings does not show it, so that the window with as much on either side, and the whole series,
// are asked too. Requires a series whose part in the window cut_to_window() has checked. Of more
// than 20000 samples every k-th serves to find the levels.
SensorLimits sensor_limits(const TimeSeries& whole, TimeWindow window);

}  // namespace slosh
