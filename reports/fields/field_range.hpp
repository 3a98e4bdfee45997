// Which values the colour bar of a flow field spans.
#pragma once

#include <string>
#include <vector>

#include "reports/model/report_model.hpp"

namespace slosh::reports {

// Whether a quantity of a field can be drawn: finite, and no diverged 1e300, which overflows in
// sums.
bool is_drawn(double value);

// The value below which the given fraction of the samples lies; they are reordered. At least one.
double percentile(std::vector<double>& samples, double fraction);

// Whether a bar can show the two ends apart.
bool is_range(double lower, double upper);

struct ColourRange {
  double lower, upper;  // lower < upper
  struct Tick {
    double value;
    std::string label;  // an end beyond which values lie carries "≤" or "≥"
  };
  std::vector<Tick> ticks;  // both ends, and round values between them
};

// The given value_range, or what holds the 1st to the 99th percentile of all panels' values,
// rounded outwards to a tick: one particle in a jet does not bleach all others.
ColourRange colour_range(const FieldFigure& figure);

}  // namespace slosh::reports
