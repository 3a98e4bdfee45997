#include "reports/drawing/axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace slosh::reports {

double round_tick(double value, bool up) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  const double mantissa = value / decade;
  if (up) return decade * (mantissa <= 1 ? 1 : mantissa <= 2 ? 2 : mantissa <= 5 ? 5 : 10);
  return decade * (mantissa >= 5 ? 5 : mantissa >= 2 ? 2 : 1);
}

namespace {

constexpr double point_margin = 0.04;  // of the axis: no point sits on the frame
constexpr double vertical_margin =
    0.06;  // of the axis, above and below the highest and lowest sample

constexpr double largest_magnitude = 1e300;  // gnuplot takes more than 1e307 as infinite
constexpr double smallest_width = 1e-9;      // of the values: a narrower curve is a flat line

bool has_place(double value, bool logarithmic) {
  return std::abs(value) < largest_magnitude && !(logarithmic && value < 1 / largest_magnitude);
}

struct Extent {
  double lower = std::numeric_limits<double>::infinity();
  double upper = -std::numeric_limits<double>::infinity();

  void include(double value, bool logarithmic) {
    if (!has_place(value, logarithmic)) return;
    lower = std::min(lower, value);
    upper = std::max(upper, value);
  }
  bool empty() const { return !(lower <= upper); }
};

AxisRange padded(const Extent& extent, bool logarithmic, double margin) {
  if (extent.empty()) return logarithmic ? AxisRange{0.1, 1} : AxisRange{0, 1};
  if (logarithmic) {
    // The range is 5 % wider than the data before rounding, which keeps samples off the frame.
    return {round_tick(extent.lower / 1.05, false), round_tick(extent.upper * 1.05, true)};
  }
  double width = extent.upper - extent.lower;
  const double size = std::max(std::abs(extent.lower), std::abs(extent.upper));
  if (!(width > smallest_width * size)) {
    width = size > 0 ? size : 1;
    margin = 0.5;
  }
  return {extent.lower - margin * width, extent.upper + margin * width};
}

bool has_points(const Figure& figure) {
  return std::any_of(figure.curves.begin(), figure.curves.end(), [](const Curve& curve) {
    return curve.style == Curve::Style::points || curve.style == Curve::Style::line_points ||
           !curve.x_error.empty() || !curve.y_error.empty();
  });
}

std::string tick_label(double value) {
  if (value >= 1e-4 && value < 1e6) return fmt::format("{:g}", value);
  const int exponent = static_cast<int>(std::floor(std::log10(value) + 1e-9));
  const long mantissa = std::lround(value / std::pow(10.0, exponent));
  return mantissa == 1 ? fmt::format("10^{{{}}}", exponent)
                       : fmt::format("{}×10^{{{}}}", mantissa, exponent);
}

}  // namespace

bool drawable(const Figure& figure, double x, double y) {
  return has_place(x, figure.log_x) && has_place(y, figure.log_y);
}

AxisRange horizontal_range(const Figure& figure) {
  if (figure.x_range.first != figure.x_range.second)
    return {figure.x_range.first, figure.x_range.second};
  Extent extent;
  for (const Curve& curve : figure.curves) {
    if (figure.equal_axes && !curve.sets_scale) continue;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      if (!drawable(figure, curve.x[i], curve.y[i])) continue;
      const double half_bar = curve.x_error.empty() ? 0.0 : curve.x_error[i];
      for (const double x : {curve.x[i], curve.x[i] - half_bar, curve.x[i] + half_bar})
        extent.include(x, figure.log_x);
    }
  }
  for (const Marker& marker : figure.markers) extent.include(marker.x, figure.log_x);
  return padded(extent, figure.log_x, has_points(figure) ? point_margin : 0.0);
}

AxisRange vertical_range(const Figure& figure, const AxisRange& horizontal) {
  if (figure.y_range.first != figure.y_range.second)
    return {figure.y_range.first, figure.y_range.second};
  Extent extent;
  const bool any_sets = std::any_of(figure.curves.begin(), figure.curves.end(),
                                    [](const Curve& curve) { return curve.sets_scale; });
  for (const Curve& curve : figure.curves) {
    if (any_sets && !curve.sets_scale) continue;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      if (!drawable(figure, curve.x[i], curve.y[i])) continue;
      if (curve.x[i] < horizontal.lower || curve.x[i] > horizontal.upper) continue;
      const double half_bar = curve.y_error.empty() ? 0.0 : curve.y_error[i];
      extent.include(curve.y[i], figure.log_y);
      extent.include(curve.y[i] - half_bar, figure.log_y);
      extent.include(curve.y[i] + half_bar, figure.log_y);
      if (curve.lower.empty()) continue;
      extent.include(curve.lower[i], figure.log_y);
      extent.include(curve.upper[i], figure.log_y);
    }
  }
  for (const Band& band : figure.bands) {
    const bool is_of_none =
        std::any_of(figure.curves.begin(), figure.curves.end(), [&](const Curve& curve) {
          return any_sets && !curve.sets_scale && band.look && band.look == curve.look;
        });
    if (is_of_none) continue;
    extent.include(band.lower, figure.log_y);
    extent.include(band.upper, figure.log_y);
  }
  return padded(extent, figure.log_y, vertical_margin);
}

PlotRanges plot_ranges(const Figure& figure) {
  const AxisRange horizontal = horizontal_range(figure);
  const AxisRange vertical = vertical_range(figure, horizontal);
  if (!figure.equal_axes) return {horizontal, vertical};
  const double half =
      std::max(horizontal.upper - horizontal.lower, vertical.upper - vertical.lower) / 2;
  const auto widened = [half](const AxisRange& range) {
    const double middle = (range.lower + range.upper) / 2;
    return AxisRange{middle - half, middle + half};
  };
  return {widened(horizontal), widened(vertical)};
}

std::string logarithmic_ticks(const AxisRange& range) {
  // The quotient of the ends may overflow. The difference of the logarithms has rounding errors.
  const double decades = std::log10(range.upper) - std::log10(range.lower) - 1e-9;
  const int step =
      std::max(1, static_cast<int>(std::ceil(decades / 8)));  // at most nine labels fit
  const std::vector<double> multiples =
      decades <= 3 ? std::vector<double>{1, 2, 5} : std::vector<double>{1};
  std::vector<std::string> ticks;
  const int first = static_cast<int>(std::floor(std::log10(range.lower)));
  const int last = static_cast<int>(std::ceil(std::log10(range.upper)));
  for (int exponent = first; exponent <= last; exponent += step) {
    for (const double multiple : multiples) {
      const double value = multiple * std::pow(10.0, exponent);
      ticks.push_back(fmt::format("'{}' {:.9g}", tick_label(value), value));
    }
  }
  return fmt::format("({})", fmt::join(ticks, ", "));
}

std::vector<std::optional<std::size_t>> drawn_samples(const Figure& figure, const Curve& curve,
                                                      std::size_t limit) {
  const std::size_t count = curve.x.size();
  // Each run gives up to three entries: its lowest and highest sample and one gap.
  const std::size_t runs = count <= limit ? count : (limit - 2) / 3;
  std::vector<std::optional<std::size_t>> drawn;
  for (std::size_t run = 0; run < runs; ++run) {
    const std::size_t end = (run + 1) * count / runs;
    std::optional<std::size_t> lowest, highest, gap;
    for (std::size_t i = run * count / runs; i < end; ++i) {
      if (!drawable(figure, curve.x[i], curve.y[i])) {
        gap = i;
        continue;
      }
      if (!lowest || curve.y[i] < curve.y[*lowest]) lowest = i;
      if (!highest || curve.y[i] > curve.y[*highest]) highest = i;
    }
    std::vector<std::size_t> kept;
    for (const auto& index : {lowest, highest, gap}) {
      if (index) kept.push_back(*index);
    }
    if (run == 0 && count > 0) kept.push_back(0);
    if (run + 1 == runs && count > 0) kept.push_back(count - 1);
    std::sort(kept.begin(), kept.end());
    kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
    for (const std::size_t i : kept) {
      drawn.push_back(drawable(figure, curve.x[i], curve.y[i]) ? std::optional(i) : std::nullopt);
    }
  }
  return drawn;
}

}  // namespace slosh::reports
