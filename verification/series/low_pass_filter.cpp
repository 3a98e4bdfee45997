#include "verification/series/low_pass_filter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

constexpr double reach_of_width = 5;
constexpr double largest_cutoff_of_nyquist = 1.0 / 3;

// The whole series, with the checks of cut_to_window().
TimeSeries checked_whole(const TimeSeries& series) {
  if (series.time.empty()) throw ComparisonError(series.name + ": no samples");
  return cut_to_window(series, {series.time.front(), series.time.back()});
}

double gaussian_width(double cutoff) {
  return std::sqrt(std::numbers::ln2) / (2 * std::numbers::pi * cutoff);
}

double widest_interval(const std::vector<double>& time) {
  double widest = 0;
  for (std::size_t i = 1; i < time.size(); ++i) widest = std::max(widest, time[i] - time[i - 1]);
  return widest;
}

void require_resolved(const TimeSeries& series, double cutoff) {
  const double widest = widest_interval(series.time);
  const double nyquist = 0.5 / widest;
  // The factor only allows for the rounding of sample times.
  const double largest = largest_cutoff_of_nyquist * nyquist * (1 + 1e-6);
  if (!(cutoff > 0) || !(cutoff <= largest)) {
    throw ComparisonError(
        fmt::format("{}: cutoff = {} Hz: expected a number > 0 and at most {:.4g} Hz, a third of "
                    "the Nyquist frequency: its samples are up to {:.3g} s apart",
                    series.name, cutoff, largest, widest));
  }
  const double length = 2 * reach_of_width * gaussian_width(cutoff);
  const double span = series.time.back() - series.time.front();
  if (span < length) {
    throw ComparisonError(
        fmt::format("{}: covers {:.4g} s; a low-pass filter at {} Hz needs {:.4g} s", series.name,
                    span, cutoff, length));
  }
}

std::vector<double> trapezoidal_weights(const std::vector<double>& time) {
  std::vector<double> weights(time.size());
  for (std::size_t i = 1; i < time.size(); ++i) {
    const double half = 0.5 * (time[i] - time[i - 1]);
    weights[i - 1] += half;
    weights[i] += half;
  }
  return weights;
}

}  // namespace

TimeSeries low_pass(const TimeSeries& series, double cutoff) {
  TimeSeries filtered = checked_whole(series);
  require_resolved(series, cutoff);
  const double width = gaussian_width(cutoff), reach = reach_of_width * width;
  const std::vector<double>& time = series.time;
  const std::vector<double> weights = trapezoidal_weights(time);
  std::size_t first = 0;
  for (std::size_t i = 0; i < time.size(); ++i) {
    while (time[first] < time[i] - reach) ++first;
    double sum = 0, weight = 0;
    for (std::size_t j = first; j < time.size() && time[j] <= time[i] + reach; ++j) {
      const double distance = (time[j] - time[i]) / width;
      const double w = weights[j] * std::exp(-0.5 * distance * distance);
      sum += w * series.value[j];
      weight += w;
    }
    filtered.value[i] = sum / weight;
  }
  return filtered;
}

std::string low_pass_name(double cutoff) {
  return fmt::format("Gaussian, zero phase, -3 dB at {} Hz", cutoff);
}

}  // namespace slosh
