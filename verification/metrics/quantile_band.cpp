#include "verification/metrics/quantile_band.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

// One interval between samples, or the part of it that lies in the window.
struct Interval {
  double length;        // [s]
  double begins, ends;  // the margin at either end
};

void require_covered(const TimeSeries& margin, TimeWindow window) {
  const std::vector<double>& time = margin.time;
  if (time.size() < 2 || !(window.begin < window.end))
    throw ComparisonError(fmt::format("{}: no samples between {:.6g} and {:.6g} s", margin.name,
                                      window.begin, window.end));
  // The longest one: the samples at the margin's corners shorten the mean.
  double interval = 0;
  for (std::size_t i = 1; i < time.size(); ++i)
    interval = std::max(interval, (time[i] - time[i - 1]) * (1 + 1e-9));
  if (window.begin < time.front() - interval || window.end > time.back() + interval)
    throw ComparisonError(
        fmt::format("{}: compared from {:.6g} to {:.6g} s; expected it to cover {:.6g} to {:.6g} s",
                    margin.name, time.front(), time.back(), window.begin, window.end));
}

std::vector<Interval> intervals_in(const TimeSeries& margin, TimeWindow window) {
  require_covered(margin, window);
  std::vector<Interval> intervals;
  for (std::size_t i = 1; i < margin.time.size(); ++i) {
    const double t0 = margin.time[i - 1], t1 = margin.time[i];
    const double from = std::max(t0, window.begin), to = std::min(t1, window.end);
    if (!(from < to)) continue;
    const auto at = [&](double t) {
      return std::lerp(margin.value[i - 1], margin.value[i], (t - t0) / (t1 - t0));
    };
    intervals.push_back({to - from, at(from), at(to)});
  }
  return intervals;
}

// The share of an interval for which a margin that is linear in it is negative.
double negative_share(const Interval& interval) {
  const auto [length, a, b] = interval;
  if (!std::isfinite(a) || !std::isfinite(b)) return not_a_number;
  if (a >= 0 && b >= 0) return 0;
  if (a < 0 && b < 0) return 1;
  return std::min(a, b) / (std::min(a, b) - std::max(a, b));
}

// How far the candidate lies above the lower edge and below the upper one.
struct Distances {
  double from_lower, from_upper;
  double margin() const { return std::min(from_lower, from_upper); }
};

// Where between two samples the nearer edge changes, as a share of the interval; nullopt where it
// does not. Both distances are linear, and so is their difference.
std::optional<double> corner_between(const Distances& one, const Distances& next) {
  const double begins = one.from_lower - one.from_upper, ends = next.from_lower - next.from_upper;
  if (!std::isfinite(begins) || !std::isfinite(ends)) return std::nullopt;
  if (!((begins < 0 && ends > 0) || (begins > 0 && ends < 0))) return std::nullopt;
  return begins / (begins - ends);
}

}  // namespace

TimeSeries band_margin(const std::vector<double>& time, const std::vector<double>& candidate,
                       const QuantileBand& band) {
  const std::vector<double> lower = interpolate(band.lower, time);
  const std::vector<double> upper = interpolate(band.upper, time);
  TimeSeries margin{"margin in the band of " + band.lower.name, band.lower.unit, {}, {}};
  std::optional<Distances> last;
  for (std::size_t i = 0; i < time.size(); ++i) {
    const Distances next{candidate[i] - lower[i], upper[i] - candidate[i]};
    if (const auto corner = last ? corner_between(*last, next) : std::nullopt) {
      margin.time.push_back(std::lerp(time[i - 1], time[i], *corner));
      margin.value.push_back(std::lerp(last->from_lower, next.from_lower, *corner));
    }
    margin.time.push_back(time[i]);
    margin.value.push_back(next.margin());
    last = next;
  }
  return margin;
}

double share_outside(const TimeSeries& margin, TimeWindow window) {
  double outside = 0, all = 0;
  for (const Interval& interval : intervals_in(margin, window)) {
    outside += interval.length * negative_share(interval);
    all += interval.length;
  }
  return outside / all;
}

}  // namespace slosh
