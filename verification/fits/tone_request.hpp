// The tones that a harmonic fit is asked for, and the checks that a window and its samples can tell
// them apart.
#pragma once

#include <string>
#include <vector>

#include "verification/series/time_series.hpp"

namespace slosh {

// A mode to be fitted. The frequency of the forced mode is known, and the mode does not decay. The
// frequency and decay rate of a natural mode are refined from the data by nonlinear least squares.
struct ToneRequest {
  std::string name;
  double angular_frequency;  // [rad/s]
  bool refine;
};

// Throws ComparisonError when the window cannot resolve the tones from one another and from the
// mean. The message names the window's length and the length needed.
void require_resolved(TimeWindow window, const std::vector<ToneRequest>& requests);

// Throws ComparisonError when there are too few samples for the tones, or when an interval between
// two samples exceeds a tenth of the period of the forced mode or of the lowest natural one, or a
// quarter of that of a higher natural mode. `cut` is cut to the window (cut_to_window()).
void require_sampled(const TimeSeries& cut, const std::vector<ToneRequest>& requests);

// The angle [rad] less whole turns, in [-pi, pi].
double wrap_angle(double angle);

}  // namespace slosh
