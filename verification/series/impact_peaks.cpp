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
  for (std::size_t i = 1; i < cut.time.size(); ++i)
    if (cut.value[i - 1] < level && cut.value[i] >= level)
      return std::lerp(cut.time[i - 1], cut.time[i],
                       (level - cut.value[i - 1]) / (cut.value[i] - cut.value[i - 1]));
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
