// Which values the colour bar of a flow field spans.
#pragma once

#include <string>
#include <vector>

#include "reports/model/report_model.hpp"

namespace slosh::reports {

// Whether a quantity of a field can be drawn: it is finite and not a diverged 1e300, which
// overflows in sums.
bool is_drawn(double value);

// The value below which the given fraction of the samples lies. Reorders the samples, of which
// there must be at least one.
double percentile(std::vector<double>& samples, double fraction);

// Whether a colour bar can tell the two ends apart.
bool is_range(double lower, double upper);

struct ColourRange {
  double lower, upper;                   // lower < upper
  double step;                           // between two ticks: 1, 2 or 5 times a power of ten
  std::string lower_label, upper_label;  // "≤" or "≥" marks an end beyond which values lie
};

// Returns the value as a bar names it.
std::string bar_label(double value);

// The ticks between the two ends of a colour bar are first, first + step, and so on up to last.
struct BarTicks {
  double first, last;
};

// Returns the ticks whose labels stay clear of those of the ends, which are drawn too, on a bar of
// this length [px].
BarTicks bar_ticks(const ColourRange& range, double bar_length);

// Returns the given value_range, or what holds the 1st to the 99th percentile of all panels'
// values, rounded outwards to a tick: one particle in a jet does not bleach all others.
ColourRange colour_range(const FieldFigure& figure);

}  // namespace slosh::reports
