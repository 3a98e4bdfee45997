#include "reports/drawing/figure_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

namespace slosh::reports {
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

// Half the width high, as a time history reads best; with equal axes nearly a square.
constexpr Canvas whole_canvas{560, 300, 56, 13, 1.8}, square_canvas{560, 440, 56, 13, 1.8},
    small_canvas{320, 196, 50, 11, 1.4};

constexpr int foot = 8;  // px, below the legend: its descenders

constexpr double character_width =
    8.5;  // px, of a 13 px sans-serif font, names with digits and underscores
constexpr double plot_width = 440;  // px, the canvas less its margins at their widest
constexpr double key_width =
    420;  // px, on the safe side: gnuplot uses fewer columns where it finds no room
constexpr double key_sample_width =
    55;  // px, the line before a legend entry and the space after it
// px, of a line of a legend entry: 54 characters. The canvas has room for 65 of usual width.
constexpr double longest_line = 460;

template <class Part, class TextOf>
std::vector<std::string> each_once(const std::vector<Part>& parts, TextOf text_of) {
  std::vector<std::string> labels;
  for (const Part& part : parts)
    if (const std::string& label = text_of(part);
        !label.empty() && std::find(labels.begin(), labels.end(), label) == labels.end())
      labels.push_back(label);
  return labels;
}

// The lines of all entries.
std::vector<std::string> legend_texts(const Figure& figure) {
  std::vector<std::string> entries = ribbon_labels(figure);
  for (const Curve& curve : figure.curves)
    if (!curve.label.empty()) entries.push_back(curve.label);
  for (const Band& band : figure.bands) entries.push_back(band.label);
  for (const std::string& label : span_labels(figure)) entries.push_back(label);
  std::vector<std::string> lines;
  for (const std::string& entry : entries)
    for (std::string& line : legend_lines(entry)) lines.push_back(std::move(line));
  return lines;
}

// The given x_range, or the range of all drawable samples, their error bars and all markers. It has
// a margin for points and none for lines.
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

// The given y_range, or the range of all drawable samples inside the horizontal range, their error
// bars, their ribbons, and all finite band levels. Curves that set no scale count only where no
// other does.
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
      for (const double y : {curve.y[i], curve.y[i] - half_bar, curve.y[i] + half_bar})
        extent.include(y, figure.log_y);
      if (curve.lower.empty()) continue;
      for (const double y : {curve.lower[i], curve.upper[i]}) extent.include(y, figure.log_y);
    }
  }
  for (const Band& band : figure.bands) {
    const bool is_of_none = std::ranges::any_of(figure.curves, [&](const Curve& curve) {
      return any_sets && !curve.sets_scale && band.look && band.look == curve.look;
    });
    if (is_of_none) continue;
    for (const double y : {band.lower, band.upper}) extent.include(y, figure.log_y);
  }
  return padded(extent, figure.log_y, vertical_margin);
}

}  // namespace

double round_tick(double value, bool up) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  const double mantissa = value / decade;
  if (up) return decade * (mantissa <= 1 ? 1 : mantissa <= 2 ? 2 : mantissa <= 5 ? 5 : 10);
  return decade * (mantissa >= 5 ? 5 : mantissa >= 2 ? 2 : 1);
}

bool drawable(const Figure& figure, double x, double y) {
  return has_place(x, figure.log_x) && has_place(y, figure.log_y);
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

double text_width(const std::string& text, double character_width) {
  const auto characters = std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  });
  return character_width * static_cast<double>(characters);
}

std::vector<std::string> wrapped(std::string rest, double width, double character_width) {
  std::vector<std::string> lines;
  while (text_width(rest, character_width) > width) {
    std::size_t end = std::string::npos;
    for (const std::string_view gap : {", ", " "}) {
      for (auto at = rest.find(gap); at != std::string::npos; at = rest.find(gap, at + 1)) {
        const std::size_t blank = at + gap.size() - 1;
        if (text_width(rest.substr(0, blank), character_width) <= width) end = blank;
      }
      if (end != std::string::npos) break;
    }
    if (end == std::string::npos) end = rest.find(' ');
    if (end == std::string::npos) break;
    lines.push_back(rest.substr(0, end));
    rest.erase(0, end + 1);
  }
  lines.push_back(rest);
  return lines;
}

Canvas canvas_of(const Figure& figure) {
  if (figure.to_scale) {
    const auto [horizontal, vertical] = plot_ranges(figure);
    const double high =
        plot_width * (vertical.upper - vertical.lower) / (horizontal.upper - horizontal.lower);
    Canvas canvas = whole_canvas;
    constexpr double above_frame = 20, lowest = 90, highest = 400;  // px
    canvas.plot_height =
        canvas.below_frame + static_cast<int>(above_frame + std::clamp(high, lowest, highest));
    return canvas;
  }
  if (figure.is_small) return small_canvas;
  return figure.equal_axes ? square_canvas : whole_canvas;
}

std::vector<std::string> span_labels(const Figure& figure) {
  return each_once(figure.spans, [](const Span& span) -> const std::string& { return span.label; });
}

std::vector<std::string> ribbon_labels(const Figure& figure) {
  return each_once(figure.curves,
                   [](const Curve& curve) -> const std::string& { return curve.ribbon; });
}

std::vector<std::string> legend_lines(const std::string& label) {
  return wrapped(label, longest_line, character_width);
}

KeyLayout key_layout(const Figure& figure) {
  if (figure.is_small) return {1, 0, 0};
  const std::vector<std::string> texts = legend_texts(figure);
  double widest = 0;
  for (const std::string& text : texts)
    widest = std::max(widest, text_width(text, character_width));
  const int columns = std::max(1, static_cast<int>(key_width / (widest + key_sample_width)));
  const double reckoned_width = 0.7 * whole_canvas.font_size;
  return {columns, (static_cast<int>(texts.size()) + columns - 1) / columns,
          widest * (1 / character_width - 1 / reckoned_width)};
}

std::vector<PlacedMarker> placed_markers(const Figure& figure, const AxisRange& range) {
  std::vector<PlacedMarker> placed;
  for (const Marker& marker : figure.markers) {
    if (marker.x >= range.lower && marker.x <= range.upper) placed.push_back({&marker, 0});
  }
  std::stable_sort(placed.begin(), placed.end(), [](const PlacedMarker& a, const PlacedMarker& b) {
    return a.marker->x < b.marker->x;
  });
  const auto scale = [&](double x) { return figure.log_x ? std::log(x) : x; };
  std::vector<double> row_ends;
  for (PlacedMarker& label : placed) {
    const double centre = plot_width * (scale(label.marker->x) - scale(range.lower)) /
                          (scale(range.upper) - scale(range.lower));
    const double half = text_width(label.marker->label, character_width) / 2 + character_width / 2;
    const auto free_row = std::find_if(row_ends.begin(), row_ends.end(),
                                       [&](double end) { return end <= centre - half; });
    label.row = static_cast<int>(free_row - row_ends.begin());
    if (free_row == row_ends.end()) row_ends.push_back(0);
    row_ends[static_cast<std::size_t>(label.row)] = centre + half;
  }
  return placed;
}

int marker_rows(const std::vector<PlacedMarker>& placed) {
  int rows = 0;
  for (const PlacedMarker& label : placed) rows = std::max(rows, label.row + 1);
  return rows;
}

int legend_height(const Figure& figure) {
  return figure.is_small ? 0 : legend_row_height * key_layout(figure).rows + foot;
}

int canvas_height(const Figure& figure) {
  const int rows =
      key_layout(figure).rows + marker_rows(placed_markers(figure, plot_ranges(figure).horizontal));
  return canvas_of(figure).plot_height + legend_row_height * rows;
}

}  // namespace slosh::reports
