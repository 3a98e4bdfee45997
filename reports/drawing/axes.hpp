// The axis ranges and ticks of a figure, and the choice of samples of a long curve to draw.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "reports/model/report_model.hpp"

namespace slosh::reports {

struct AxisRange {
  double lower, upper;  // lower < upper, both finite; both positive on a logarithmic axis
};

// The nearest 1, 2 or 5 times a power of ten at or beyond the value, which is above zero.
double round_tick(double value, bool up);

// Returns the given x_range, or the range of all drawable samples, their error bars and all
// markers. It has a margin for points and none for lines.
AxisRange horizontal_range(const Figure& figure);

// Returns the given y_range, or the range of all drawable samples inside the horizontal range,
// their error bars, their ribbons, and all finite band levels. Curves that set no scale count only
// where no other does.
AxisRange vertical_range(const Figure& figure, const AxisRange& horizontal);

struct PlotRanges {
  AxisRange horizontal, vertical;
};

// Returns both ranges. Where the figure's axes are equal, the narrower range is widened about its
// middle.
PlotRanges plot_ranges(const Figure& figure);

// Returns gnuplot's tick list for a logarithmic axis. The ticks are at 1, 2 and 5 times the powers
// of ten over up to three decades, and at powers of ten over more.
std::string logarithmic_ticks(const AxisRange& range);

// Whether gnuplot can place the sample: it is finite (a diverged 1e300 does not count as finite),
// and positive on logarithmic axes.
bool drawable(const Figure& figure, double x, double y);

// Returns the indices of the samples to draw, in order, at most `limit` (>= 5) of them;
// std::nullopt is a gap. A longer curve is cut into equal runs of samples. The lowest sample, the
// highest and one gap of each run are kept, and the curve's two ends.
std::vector<std::optional<std::size_t>> drawn_samples(const Figure& figure, const Curve& curve,
                                                      std::size_t limit);

}  // namespace slosh::reports
