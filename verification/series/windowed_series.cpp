#include "verification/series/windowed_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/interpolators/makima.hpp>
#include <cmath>
#include <utility>
#include <vector>

#include "verification/series/sample_moments.hpp"

namespace slosh {
namespace {

constexpr double rounding_s = 1e-12;  // of sample times
constexpr std::size_t makima_stencil = 4;

void require_sound_samples(const TimeSeries& series) {
  if (series.time.size() != series.value.size()) {
    throw ComparisonError(fmt::format("{}: {} times but {} values; expected as many of both",
                                      series.name, series.time.size(), series.value.size()));
  }
  if (series.time.size() < makima_stencil) {
    throw ComparisonError(fmt::format("{}: only {} samples; expected at least {}", series.name,
                                      series.time.size(), makima_stencil));
  }
  for (std::size_t i = 0; i < series.time.size(); ++i) {
    if (!std::isfinite(series.time[i]) || !std::isfinite(series.value[i])) {
      throw ComparisonError(fmt::format("{}: sample {} is not finite: time {} s, value {} {}",
                                        series.name, i, series.time[i], series.value[i],
                                        series.unit));
    }
    if (i > 0 && !(series.time[i] > series.time[i - 1])) {
      throw ComparisonError(fmt::format("{}: times do not increase: {} s after {} s (sample {})",
                                        series.name, series.time[i], series.time[i - 1], i));
    }
  }
}

void require_coverage(const TimeSeries& series, TimeWindow window) {
  if (!(window.end > window.begin) || !std::isfinite(window.end - window.begin)) {
    throw ComparisonError(
        fmt::format("window {} s to {} s is not an interval of time", window.begin, window.end));
  }
  const double first = series.time.front(), last = series.time.back();
  const double mean_interval = (last - first) / static_cast<double>(series.time.size() - 1);
  // The factor only allows for the rounding of sample times.
  const double slack = mean_interval * (1 + 1e-6);
  if (first > window.begin + slack || last < window.end - slack) {
    throw ComparisonError(fmt::format(
        "{}: covers {} s to {} s; expected {} s to {} s to within one sample of {:.3g} s",
        series.name, first, last, window.begin, window.end, mean_interval));
  }
}

}  // namespace

TimeSeries cut_to_window(const TimeSeries& series, TimeWindow window) {
  require_sound_samples(series);
  require_coverage(series, window);
  const auto first = std::lower_bound(series.time.begin(), series.time.end(), window.begin);
  const auto last = std::upper_bound(first, series.time.end(), window.end);
  if (last - first < static_cast<std::ptrdiff_t>(makima_stencil)) {
    throw ComparisonError(
        fmt::format("{}: only {} samples between {} s and {} s; expected at least {}", series.name,
                    last - first, window.begin, window.end, makima_stencil));
  }
  const auto value_at = [&](auto time) {
    return series.value.begin() + (time - series.time.begin());
  };
  return {.name = series.name,
          .unit = series.unit,
          .time = {first, last},
          .value = {value_at(first), value_at(last)}};
}

TimeSeries with_part(TimeSeries whole, const TimeSeries& part) {
  const auto first = std::lower_bound(whole.time.begin(), whole.time.end(), part.time.front());
  std::copy(part.value.begin(), part.value.end(),
            whole.value.begin() + (first - whole.time.begin()));
  return whole;
}

double median_sample_interval(const std::vector<double>& times) {
  const std::size_t stride = times.size() / 20000 + 1;
  std::vector<double> intervals;
  for (std::size_t i = 1; i < times.size(); i += stride)
    intervals.push_back(times[i] - times[i - 1]);
  return median(std::move(intervals));
}

std::vector<double> departures_from_neighbours(const TimeSeries& series) {
  const auto& [name, unit, time, value] = series;
  std::vector<double> departures;
  for (std::size_t i = 1; i + 1 < value.size(); ++i) {
    const double share = (time[i] - time[i - 1]) / (time[i + 1] - time[i - 1]);
    departures.push_back(std::abs(value[i] - std::lerp(value[i - 1], value[i + 1], share)));
  }
  return departures;
}

bool is_constant(const TimeSeries& series) {
  const auto [low, high] = std::minmax_element(series.value.begin(), series.value.end());
  constexpr double least = 1e-150;  // the squares of less are 0
  const double rounding = std::max(least, 1e-12 * std::max(std::abs(*low), std::abs(*high)));
  return !(*high - *low > rounding);
}

void require_variation(const TimeSeries& series) {
  if (is_constant(series))
    throw ComparisonError(fmt::format("{}: constant at {} {} from {} s to {} s; nothing to compare",
                                      series.name, series.value.front(), series.unit,
                                      series.time.front(), series.time.back()));
}

std::vector<double> Interpolant::at(const std::vector<double>& times) const {
  const std::vector<double>& known = series_.time;
  std::vector<double> values;
  values.reserve(times.size());
  auto after = known.begin();  // the first sample that is not before the time
  for (const double time : times) {
    const auto is_before = [time](double sample) { return sample < time - rounding_s; };
    if (after != known.begin() && !is_before(*(after - 1)))
      after = std::partition_point(known.begin(), after, is_before);
    while (after != known.end() && is_before(*after)) ++after;
    if (after != known.end() && std::abs(*after - time) <= rounding_s) {
      values.push_back(series_.value[static_cast<std::size_t>(after - known.begin())]);
      continue;
    }
    if (!curve_)
      curve_ = boost::math::interpolators::makima(std::vector<double>(known),
                                                  std::vector<double>(series_.value));
    values.push_back(curve_(time));
  }
  return values;
}

std::vector<double> interpolate(const TimeSeries& series, const std::vector<double>& times) {
  return Interpolant(series).at(times);
}

CommonSamples common_samples(const TimeSeries& candidate, const TimeSeries& cut_reference) {
  CommonSamples common;
  for (std::size_t i = 0; i < cut_reference.time.size(); ++i) {
    const double t = cut_reference.time[i];
    if (t < candidate.time.front() || t > candidate.time.back()) continue;
    common.time.push_back(t);
    common.reference.push_back(cut_reference.value[i]);
  }
  common.candidate = interpolate(candidate, common.time);
  return common;
}

std::vector<double> uniform_times(double begin, double end, std::size_t count) {
  std::vector<double> times(count);
  for (std::size_t i = 0; i < count; ++i) {
    times[i] = std::lerp(begin, end, static_cast<double>(i) / static_cast<double>(count - 1));
  }
  return times;
}

void remove_trend(std::vector<double>& values) {
  const double middle = 0.5 * static_cast<double>(values.size() - 1);
  double sum = 0, moment = 0, inertia = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double x = static_cast<double>(i) - middle;
    sum += values[i];
    moment += x * values[i];
    inertia += x * x;
  }
  const double mean = sum / static_cast<double>(values.size());
  const double slope = moment / inertia;
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] -= mean + slope * (static_cast<double>(i) - middle);
  }
}

}  // namespace slosh
