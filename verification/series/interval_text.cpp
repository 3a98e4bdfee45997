#include "verification/series/interval_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace slosh {
namespace {

constexpr int most_digits = 4;    // of a value
constexpr int most_decimals = 5;  // beyond them a power of ten stands after the brackets

int exponent_of(double value) { return static_cast<int>(std::floor(std::log10(value))); }

// The power of ten of the last digit that is shown. A half width that exceeds the value keeps two
// digits, as the value would be lost otherwise.
int last_place(double value, double half_width) {
  const int first = exponent_of(half_width);
  const double digits = std::round(half_width / std::pow(10, first - 1));  // 10 to 100
  if (digits >= 100) return first;
  return digits < 30 || half_width > std::abs(value) ? first - 1 : first;
}

std::string in_brackets(double value, double half_width, int place) {
  const int power = exponent_of(std::max(std::abs(value), half_width));
  const double scale = std::pow(10, power);
  const int decimals = std::max(0, power - place);
  return fmt::format("({:.{}f} ± {:.{}f})e{:+03d}", 0.0 + value / scale, decimals,
                     half_width / scale, decimals, power);
}

}  // namespace

double round_to_place(double value, int place) {
  const double unit = std::pow(10, std::abs(place));
  return 0.0 + (place < 0 ? std::round(value * unit) / unit : std::round(value / unit) * unit);
}

std::string three_digits(double value) {
  const double size = std::abs(value);
  const bool is_long = size >= 999.5 && size < 1e7;
  return is_long ? fmt::format("{:.0f}", round_to_place(value, exponent_of(size) - 2))
                 : fmt::format("{:.3g}", 0.0 + value);  // no negative zero
}

std::string interval_text(const Estimate& estimate) {
  const double value = 0.0 + estimate.value, half_width = estimate.half_width;  // no negative zero
  if (std::isinf(half_width)) return "not determined";
  if (!(half_width > 0) || !std::isfinite(value)) return three_digits(value);
  int place = last_place(value, half_width);
  double shown_half = round_to_place(half_width, place);
  if (value != 0) {
    const int fourth = exponent_of(std::abs(value)) - most_digits + 1;
    if (half_width < std::pow(10, fourth - 1)) return three_digits(value);
    if (fourth > place) {
      place = fourth;
      shown_half = std::max(round_to_place(half_width, place), std::pow(10, place));
    }
  }
  const double shown = round_to_place(value, place);
  if (-place > most_decimals) return in_brackets(shown, shown_half, place);
  const int decimals = std::max(0, -place);
  return fmt::format("{:.{}f} ± {:.{}f}", shown, decimals, shown_half, decimals);
}

std::string percent_interval_text(const Estimate& estimate) {
  return interval_text({100 * estimate.value, 100 * estimate.half_width}) + " %";
}

std::string slope_text(const Estimate& slope) {
  if (std::isnan(slope.half_width)) return fmt::format("{:.2f}", slope.value);
  return slope.half_width >= std::abs(slope.value) ? "not determined" : interval_text(slope);
}

}  // namespace slosh
