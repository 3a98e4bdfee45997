#include "verification/series/impact_peaks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

// Whether the sample is higher than its neighbours; of several equal samples the first counts.
bool is_local_maximum(const std::vector<double>& value, std::size_t i) {
  if (i == 0 || !(value[i] > value[i - 1])) return false;
  const auto next = std::find_if(value.begin() + static_cast<std::ptrdiff_t>(i), value.end(),
                                 [&](double v) { return v != value[i]; });
  return next != value.end() && *next < value[i];
}

std::optional<ImpactPeak> highest_peak(const TimeSeries& pressure, TimeWindow window,
                                       double threshold) {
  const auto index = [&](double time) {
    const auto at = std::lower_bound(pressure.time.begin(), pressure.time.end(), time);
    return static_cast<std::size_t>(at - pressure.time.begin());
  };
  std::optional<ImpactPeak> highest;
  for (std::size_t i = index(window.begin); i < index(window.end); ++i) {
    const double value = pressure.value[i];
    if (value > (highest ? highest->pressure : threshold) && is_local_maximum(pressure.value, i))
      highest = ImpactPeak{.time = pressure.time[i], .pressure = value};
  }
  return highest;
}

// The time within [from, to] in which the pressure is at the level or above it between two samples.
double time_above(const TimeSeries& series, std::size_t second, double level, double from,
                  double to) {
  const double t0 = series.time[second - 1], t1 = series.time[second];
  const double begin = std::max(from, t0), end = std::min(to, t1);
  if (!(begin < end)) return 0;
  const auto at = [&](double t) {
    return std::lerp(series.value[second - 1], series.value[second], (t - t0) / (t1 - t0));
  };
  const auto [low, high] = std::minmax({at(begin), at(end)});
  if (low >= level) return end - begin;
  return high > level ? (end - begin) * (high - level) / (high - low) : 0;
}

constexpr double held_share = 0.5;

struct Upcrossing {
  double time, held;  // [s]
};

// All times at which the pressure comes to the level from below, each with how long it is there
// within the time `after` it.
std::vector<Upcrossing> upcrossings(const TimeSeries& series, double level, double after) {
  std::vector<Upcrossing> found;
  for (std::size_t i = 1; i < series.time.size(); ++i) {
    if (!(series.value[i - 1] < level && series.value[i] >= level)) continue;
    const double t =
        std::lerp(series.time[i - 1], series.time[i],
                  (level - series.value[i - 1]) / (series.value[i] - series.value[i - 1]));
    double held = 0;
    for (std::size_t j = i; j < series.time.size() && series.time[j - 1] < t + after; ++j)
      held += time_above(series, j, level, t, t + after);
    found.push_back({t, held});
  }
  return found;
}

}  // namespace

std::vector<TimeWindow> impact_windows(double start, double period, int count) {
  std::vector<TimeWindow> windows;
  for (int i = 0; i < count; ++i)
    windows.push_back({.begin = start + i * period, .end = start + (i + 1) * period});
  return windows;
}

std::vector<TimeWindow> impact_windows(const std::vector<double>& expected_times, double period) {
  std::vector<TimeWindow> windows;
  for (const double time : expected_times)
    windows.push_back({.begin = time - 0.25 * period, .end = time + 0.25 * period});
  return windows;
}

double impact_threshold(const std::vector<double>& mean_peaks) {
  if (mean_peaks.empty()) throw ComparisonError("an impact's threshold: expected published peaks");
  return impact_share * *std::min_element(mean_peaks.begin(), mean_peaks.end());
}

std::vector<std::optional<ImpactPeak>> impact_peaks(const TimeSeries& pressure,
                                                    const std::vector<TimeWindow>& windows,
                                                    double threshold) {
  if (windows.empty()) throw ComparisonError(pressure.name + ": no windows to seek impacts in");
  if (!(threshold > 0) || !std::isfinite(threshold)) {
    throw ComparisonError(fmt::format(
        "{}: an impact's threshold = {}: expected a number > 0, in Pa", pressure.name, threshold));
  }
  std::vector<std::optional<ImpactPeak>> peaks;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    cut_to_window(pressure, windows[i]);  // only for its checks
    if (i > 0 && windows[i].begin < windows[i - 1].end) {
      throw ComparisonError(fmt::format(
          "{}: the window of impact {} begins at {} s; expected at or after the last one's end, "
          "{} s",
          pressure.name, i + 1, windows[i].begin, windows[i - 1].end));
    }
    peaks.push_back(highest_peak(pressure, windows[i], threshold));
  }
  return peaks;
}

std::optional<double> arrival_time(const TimeSeries& pressure, TimeWindow window, double level) {
  if (!(level > 0) || !std::isfinite(level))
    throw ComparisonError(fmt::format(
        "{}: the level of an arrival = {}: expected a number > 0, in Pa", pressure.name, level));
  const TimeSeries cut = cut_to_window(pressure, window);
  const std::vector<Upcrossing> found = upcrossings(cut, level, (window.end - window.begin) / 25);
  double longest = 0;
  for (const Upcrossing& one : found) longest = std::max(longest, one.held);
  for (const Upcrossing& one : found)
    if (one.held >= held_share * longest) return one.time;
  return std::nullopt;
}

std::optional<double> rise_time(const TimeSeries& pressure, const ImpactPeak& peak) {
  const double half = 0.5 * peak.pressure;
  const auto at = std::lower_bound(pressure.time.begin(), pressure.time.end(), peak.time);
  for (auto i = static_cast<std::size_t>(at - pressure.time.begin()); i > 0; --i)
    if (pressure.value[i - 1] < half) {
      const double t_half =
          std::lerp(pressure.time[i - 1], pressure.time[i],
                    (half - pressure.value[i - 1]) / (pressure.value[i] - pressure.value[i - 1]));
      return 2 * (peak.time - t_half);
    }
  return std::nullopt;
}

double impulse(const TimeSeries& pressure, TimeWindow window) {
  cut_to_window(pressure, window);  // only for its checks
  double sum = 0;
  for (std::size_t i = 1; i < pressure.time.size(); ++i) {
    const double t0 = pressure.time[i - 1], t1 = pressure.time[i];
    const double from = std::max(t0, window.begin), to = std::min(t1, window.end);
    if (!(from < to)) continue;
    const auto at = [&](double t) {
      return std::lerp(pressure.value[i - 1], pressure.value[i], (t - t0) / (t1 - t0));
    };
    sum += 0.5 * (to - from) * (at(from) + at(to));
  }
  return sum;
}

double plateau_mean(const TimeSeries& series, TimeWindow window) {
  const TimeSeries cut = cut_to_window(series, window);
  double sum = 0;
  for (std::size_t i = 1; i < cut.time.size(); ++i)
    sum += 0.5 * (cut.time[i] - cut.time[i - 1]) * (cut.value[i] + cut.value[i - 1]);
  return sum / (cut.time.back() - cut.time.front());
}

}  // namespace slosh
