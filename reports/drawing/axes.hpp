// Axis ranges and ticks of a figure, and which samples of a long curve are worth drawing.
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

// The given x_range, or what holds every drawable sample, its error bar and every marker: flush
// with lines, with a margin for points.
AxisRange horizontal_range(const Figure& figure);

// What holds every drawable sample inside the horizontal range, its error bar, its ribbon, and
// every finite band level.
AxisRange vertical_range(const Figure& figure, const AxisRange& horizontal);

struct PlotRanges {
  AxisRange horizontal, vertical;
};

// Both; where the figure's axes are equal, the narrower one widened about its middle.
PlotRanges plot_ranges(const Figure& figure);

// gnuplot's tick list for a logarithmic axis: at 1, 2 and 5 times the powers of ten over up to
// three decades, at powers of ten over more.
std::string logarithmic_ticks(const AxisRange& range);

// Whether gnuplot can place the sample: finite (a diverged 1e300 is not), and positive on
// logarithmic axes.
bool drawable(const Figure& figure, double x, double y);

// Sample numbers to draw, in order, at most `limit` (>= 5) entries; std::nullopt is a gap. A longer
// curve is cut into equal runs of samples of which the lowest, the highest and one gap are kept,
// besides the curve's two ends.
std::vector<std::optional<std::size_t>> drawn_samples(const Figure& figure, const Curve& curve,
                                                      std::size_t limit);

}  // namespace slosh::reports
