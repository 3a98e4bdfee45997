#include "reports/fields/field_range.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <cmath>

#include "reports/drawing/axes.hpp"

namespace slosh::reports {
namespace {

constexpr double largest_magnitude = 1e300;
constexpr double robust_fraction = 0.01;  // of the values, left out at either end
constexpr double smallest_width = 1e-9;  // of the values: fields this even get a range of their own
constexpr int fewest_steps = 5;          // between the ticks of a bar

std::string tick_label(double value) {
  return boost::replace_all_copy(fmt::format("{:.6g}", value), "-", "−");
}

// A range that holds both, ends at multiples of the step, and the step.
struct RoundRange {
  double lower, upper, step;
};

RoundRange rounded(double lower, double upper) {
  const double step = round_tick((upper - lower) / fewest_steps, false);
  // A value that differs from a multiple by rounding errors alone is that multiple.
  const double slack = 1e-6;
  return {step * std::floor(lower / step + slack), step * std::ceil(upper / step - slack), step};
}

RoundRange automatic_range(std::vector<double>& samples) {
  if (samples.empty()) return {0, 1, 0.2};
  const double lower = percentile(samples, robust_fraction),
               upper = percentile(samples, 1 - robust_fraction);
  if (is_range(lower, upper)) return rounded(lower, upper);
  const double size = std::max(std::abs(lower), std::abs(upper));
  const double half = size > 1 / largest_magnitude ? size / 2 : 0.5;
  return rounded(lower - half, upper + half);
}

}  // namespace

bool is_drawn(double value) { return std::abs(value) < largest_magnitude; }

bool is_range(double lower, double upper) {
  const double size = std::max(std::abs(lower), std::abs(upper));
  return is_drawn(lower) && is_drawn(upper) &&
         upper - lower > std::max(smallest_width * size, 1 / largest_magnitude);
}

double percentile(std::vector<double>& samples, double fraction) {
  const auto rank = std::llround(fraction * static_cast<double>(samples.size() - 1));
  const auto place = samples.begin() + rank;
  std::nth_element(samples.begin(), place, samples.end());
  return *place;
}

ColourRange colour_range(const FieldFigure& figure) {
  std::vector<double> samples;
  for (const FieldPanel& panel : figure.panels)
    std::copy_if(panel.value.begin(), panel.value.end(), std::back_inserter(samples), is_drawn);
  const auto [given_lower, given_upper] = figure.value_range;
  const RoundRange range =
      given_lower == given_upper
          ? automatic_range(samples)
          : RoundRange{given_lower, given_upper,
                       round_tick((given_upper - given_lower) / fewest_steps, false)};
  ColourRange bar{range.lower, range.upper, {}};
  const auto beyond = [&](auto compare, double end) {
    return std::any_of(samples.begin(), samples.end(),
                       [&](double value) { return compare(value, end); });
  };
  bar.ticks.push_back(
      {range.lower, (beyond(std::less<>(), range.lower) ? "≤ " : "") + tick_label(range.lower)});
  const double room = 0.6 * range.step;  // to an end, whose label is the wider one
  for (double tick = range.step * std::ceil((range.lower + room) / range.step);
       tick < range.upper - room; tick += range.step) {
    // Multiples of a step that is no binary fraction miss zero by rounding errors.
    const double value = std::abs(tick) < 1e-6 * range.step ? 0.0 : tick;
    bar.ticks.push_back({value, tick_label(value)});
  }
  bar.ticks.push_back(
      {range.upper, (beyond(std::greater<>(), range.upper) ? "≥ " : "") + tick_label(range.upper)});
  return bar;
}

}  // namespace slosh::reports
