#include "reports/drawing/field_range.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <cmath>

#include "reports/drawing/axes.hpp"
#include "reports/drawing/figure_layout.hpp"

namespace slosh::reports {
namespace {

constexpr double largest_drawn_value = 1e300;
constexpr double robust_fraction = 0.01;  // of the values, left out at either end
constexpr double narrowest_range = 1e-9;  // of the values: more uniform fields get a wider range
constexpr int fewest_steps = 5;           // between the ticks of a bar
constexpr double letter_width = 7.6;      // [px], of gnuplot's 'sans,12'
constexpr double label_gap = 10;          // [px], between the labels of two ticks

// The smallest range that holds both values and ends at multiples of its step.
ColourRange rounded(double lower, double upper) {
  const double step = round_tick((upper - lower) / fewest_steps, false);
  // A value that differs from a multiple by rounding errors alone is that multiple.
  const double slack = 1e-6;
  return {step * std::floor(lower / step + slack), step * std::ceil(upper / step - slack), step, "",
          ""};
}

ColourRange automatic_range(std::vector<double>& samples) {
  if (samples.empty()) return rounded(0, 1);
  const double lower = percentile(samples, robust_fraction),
               upper = percentile(samples, 1 - robust_fraction);
  if (is_range(lower, upper)) return rounded(lower, upper);
  const double size = std::max(std::abs(lower), std::abs(upper));
  const double half = size > 1 / largest_drawn_value ? size / 2 : 0.5;
  return rounded(lower - half, upper + half);
}

}  // namespace

bool is_drawn(double value) { return std::abs(value) < largest_drawn_value; }

bool is_range(double lower, double upper) {
  const double size = std::max(std::abs(lower), std::abs(upper));
  return is_drawn(lower) && is_drawn(upper) &&
         upper - lower > std::max(narrowest_range * size, 1 / largest_drawn_value);
}

double percentile(std::vector<double>& samples, double fraction) {
  const auto rank = std::llround(fraction * static_cast<double>(samples.size() - 1));
  const auto place = samples.begin() + rank;
  std::nth_element(samples.begin(), place, samples.end());
  return *place;
}

std::string bar_label(double value) {
  return boost::replace_all_copy(fmt::format("{:.6g}", value), "-", "−");
}

BarTicks bar_ticks(const ColourRange& range, double bar_length) {
  const double value_of_pixel = (range.upper - range.lower) / bar_length;
  // Half of both labels beside each other and a gap, as a difference of values.
  const auto room = [&](const std::string& end, double neighbour) {
    const double labels = text_width(end + bar_label(neighbour), letter_width);
    return (labels / 2 + label_gap) * value_of_pixel;
  };
  const auto multiple = [&](double steps) { return range.step * steps; };
  BarTicks ticks{multiple(std::floor(range.lower / range.step) + 1),
                 multiple(std::ceil(range.upper / range.step) - 1)};
  while (ticks.first - range.lower < room(range.lower_label, ticks.first) &&
         ticks.first < range.upper)
    ticks.first += range.step;
  while (range.upper - ticks.last < room(range.upper_label, ticks.last) && ticks.last > range.lower)
    ticks.last -= range.step;
  return ticks;
}

ColourRange colour_range(const FieldFigure& figure) {
  std::vector<double> samples;
  for (const FieldPanel& panel : figure.panels)
    std::copy_if(panel.value.begin(), panel.value.end(), std::back_inserter(samples), is_drawn);
  const auto [lower, upper] = figure.value_range;
  ColourRange range =
      lower == upper
          ? automatic_range(samples)
          : ColourRange{lower, upper, round_tick((upper - lower) / fewest_steps, false), "", ""};
  const auto is_below = [&](double value) { return value < range.lower; };
  const auto is_above = [&](double value) { return value > range.upper; };
  range.lower_label =
      (std::any_of(samples.begin(), samples.end(), is_below) ? "≤ " : "") + bar_label(range.lower);
  range.upper_label =
      (std::any_of(samples.begin(), samples.end(), is_above) ? "≥ " : "") + bar_label(range.upper);
  return range;
}

}  // namespace slosh::reports
