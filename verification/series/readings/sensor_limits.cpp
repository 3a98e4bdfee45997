#include "verification/series/readings/sensor_limits.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "verification/series/readings/lost_share.hpp"
#include "verification/series/sample_moments.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

constexpr int most_steps = 100;
constexpr double on_levels = 0.9;              // of the samples
constexpr double off_level = 0.01;             // [steps] by rounding
constexpr double same_line = 1e-5;             // of the range, by rounding
constexpr double least_isolated = 0.05;        // of the range
constexpr double least_isolated_share = 0.01;  // of the mean departure from the mean
constexpr double least_rough = 0.4;            // of the standard deviation
constexpr std::size_t fewest_readings = 6;
constexpr std::size_t most_sampled = 20000;

// The values that are read more than once, in order; empty where too few samples have them.
std::vector<double> repeated_values(const std::vector<double>& values) {
  const std::size_t stride = values.size() / most_sampled + 1;
  std::vector<double> sorted;
  for (std::size_t i = 0; i < values.size(); i += stride) sorted.push_back(values[i]);
  std::sort(sorted.begin(), sorted.end());
  std::vector<double> repeated;
  std::size_t samples = 0;
  for (auto at = sorted.begin(); at != sorted.end();) {
    const auto next = std::upper_bound(at, sorted.end(), *at);
    if (next - at > 1) {
      repeated.push_back(*at);
      samples += static_cast<std::size_t>(next - at);
    }
    at = next;
  }
  const bool most = static_cast<double>(samples) >= on_levels * static_cast<double>(sorted.size());
  return most ? repeated : std::vector<double>{};
}

std::optional<double> step_of(const std::vector<double>& values) {
  const std::vector<double> levels = repeated_values(values);
  if (levels.size() < 2 || levels.size() > most_steps) return std::nullopt;
  for (int steps = 1; steps < most_steps; ++steps) {
    const double step = (levels.back() - levels.front()) / steps;
    const auto is_level = [&](double value) {
      const double place = (value - levels.front()) / step;
      return std::abs(place - std::round(place)) <= off_level;
    };
    if (std::all_of(levels.begin(), levels.end(), is_level)) return step;
  }
  return std::nullopt;
}

// Consecutive samples on one straight line, or of one value where these are held.
struct Piece {
  std::size_t first, last;
  double turn;  // by which the series leaves it
};

// What 8 first quartiles exceed is no noise within the pieces, and no step of a smooth wave.
std::vector<Piece> pieces_of(const TimeSeries& series, double range, bool held) {
  const std::vector<double>&time = series.time, &value = series.value;
  std::vector<double> left(value.size(), 0), sizes;  // by which the next sample leaves the line
  for (std::size_t i = 1; i + 1 < value.size(); ++i) {
    const double before = held ? 0 : (value[i] - value[i - 1]) / (time[i] - time[i - 1]);
    left[i] = value[i + 1] - value[i] - before * (time[i + 1] - time[i]);
    sizes.push_back(std::abs(left[i]));
  }
  if (sizes.empty()) return {};
  const auto quartile = sizes.begin() + std::ssize(sizes) / 4;
  std::nth_element(sizes.begin(), quartile, sizes.end());
  const double same = std::max(same_line * range, 8 * *quartile);
  std::vector<Piece> pieces;
  std::size_t first = 0;
  for (std::size_t i = 1; i + 1 < value.size(); ++i) {
    if (std::abs(left[i]) <= same) continue;
    pieces.push_back({first, i, left[i] / (held ? 1 : time[i + 1] - time[i])});
    first = held ? i + 1 : i;
  }
  if (!pieces.empty()) pieces.push_back({first, value.size() - 1, 0});
  return pieces;
}

// The mean of the values, or the slope.
double course_of(const Piece& piece, const TimeSeries& series, bool held) {
  const auto& [name, unit, time, value] = series;
  if (!held)
    return (value[piece.last] - value[piece.first]) / (time[piece.last] - time[piece.first]);
  const auto begin = value.begin() + static_cast<std::ptrdiff_t>(piece.first);
  return mean({begin, value.begin() + static_cast<std::ptrdiff_t>(piece.last) + 1});
}

// A rest between samples that follow the wave is no reading, nor is a piece that ends at an outlier
// of the noise: the reading after one is long too, to a factor, and goes on where the series turned
// to.
std::optional<SparseReadings> sparse_readings(const TimeSeries& series, double range) {
  const double fine = 1.5 * median_sample_interval(series.time);
  for (const bool held : {true, false}) {
    const std::vector<Piece> pieces = pieces_of(series, range, held);
    const auto length = [&](const Piece& piece) {
      return series.time[std::min(piece.last + held, series.time.size() - 1)] -
             series.time[piece.first];
    };
    std::vector<double> intervals, turns;
    double covered = 0, all = 0;
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
      const Piece &piece = pieces[i], &next = pieces[i + 1];
      const auto [shorter, longer] = std::minmax({length(piece), length(next)});
      if (shorter < fine) continue;
      all += length(piece);
      const double turn = course_of(next, series, held) - course_of(piece, series, held);
      if (longer > 3 * shorter || std::abs(turn - piece.turn) > std::abs(piece.turn) / 2) continue;
      intervals.push_back(length(piece));
      turns.push_back(std::abs(turn));
      covered += length(piece);
    }
    if (intervals.size() < fewest_readings || covered < 0.8 * all) continue;
    const double interval = median(intervals), turn = median(turns);
    const double hidden = held ? turn / 2 : turn * interval / 8;
    const double share = covered / (series.time.back() - series.time.front());
    if (share * hidden >= least_hidden * range) return SparseReadings{held, interval, hidden};
  }
  return std::nullopt;
}

double range_of(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *high - *low;
}

TimeSeries without(const std::vector<bool>& left_out, const TimeSeries& series) {
  TimeSeries kept{series.name, series.unit, {}, {}};
  for (std::size_t i = 0; i < series.value.size(); ++i) {
    if (left_out[i]) continue;
    kept.time.push_back(series.time[i]);
    kept.value.push_back(series.value[i]);
  }
  return kept;
}

// Runs of one or two samples, or of more of one value, that leave the line between their
// neighbours, which follow one another.
struct Isolated {
  std::vector<bool> is_isolated;
  std::optional<IsolatedReadings> told;
};

class IsolatedSearch {
 public:
  IsolatedSearch(const TimeSeries& series, double range) : series_(series) {
    found_.is_isolated.resize(series.value.size());
    if (series.value.size() < fewest_readings) return;
    least_ = std::max(8 * median(departures_from_neighbours(series)), least_isolated * range);
    same_ = same_line * range;
    for (std::size_t count = 1; count < fewest_in_flat; ++count)
      for (std::size_t i = 2; i + count + 1 < series.value.size(); ++i) look_at(i, count);
    for (std::size_t i = 2; i < series.value.size();) {
      const std::size_t count = of_one_value(i);
      if (count >= fewest_in_flat && i + count + 1 < series.value.size()) look_at(i, count);
      i += count;
    }
  }

  Isolated found() {
    double swing = 0;
    for (const double one : without_mean(series_.value)) swing += std::abs(one);
    told_.above = off_ > 0;
    if (told_.count > 1 && highest_ - lowest_ <= same_) told_.value = highest_;
    const auto samples = static_cast<double>(series_.value.size());
    told_.hidden /= samples;
    if (told_.hidden > 0 && told_.hidden >= least_isolated_share * swing / samples)
      found_.told = told_;
    return std::move(found_);
  }

 private:
  // By which a sample leaves the line between two others.
  double left(std::size_t i, std::size_t before, std::size_t after) const {
    const std::vector<double>&time = series_.time, &value = series_.value;
    const double share = (time[i] - time[before]) / (time[after] - time[before]);
    return value[i] - std::lerp(value[before], value[after], share);
  }

  std::size_t of_one_value(std::size_t first) const {
    std::size_t i = first;
    while (i < series_.value.size() && std::abs(series_.value[i] - series_.value[first]) <= same_)
      ++i;
    return i - first;
  }

  void look_at(std::size_t i, std::size_t count) {
    const std::size_t before = i - 1, after = i + count;
    const double apart =
        std::min(std::abs(left(i, before, after)), std::abs(left(after - 1, before, after)));
    const double beside = std::max(std::abs(left(before, before - 1, after)),
                                   std::abs(left(after, before, after + 1)));
    if (apart < least_ || apart < 5 * beside || found_.is_isolated[i]) return;
    for (std::size_t k = i; k < after; ++k) {
      found_.is_isolated[k] = true;
      off_ += left(k, before, after);
      told_.hidden += std::abs(left(k, before, after));
      highest_ = std::max(highest_, series_.value[k]);
      lowest_ = std::min(lowest_, series_.value[k]);
    }
    told_.count += count;
    if (apart > largest_) told_.time = series_.time[i];
    largest_ = std::max(largest_, apart);
  }

  const TimeSeries& series_;
  double least_ = 0, same_ = 0;
  Isolated found_;
  IsolatedReadings told_{0, 0, 0};
  double off_ = 0, largest_ = 0;  // the sum, and the largest
  double highest_ = -std::numeric_limits<double>::infinity(), lowest_ = -highest_;
};

std::optional<FlatExtreme> flat_trough(TimeSeries series, double step, TimeWindow window) {
  for (double& value : series.value) value = -value;
  auto flat = flat_crest(series, step, window);
  if (flat) flat->value = -flat->value;
  return flat;
}

std::optional<double> roughness_of(const TimeSeries& cut) {
  if (cut.value.size() < fewest_readings) return std::nullopt;
  const double roughness = median(departures_from_neighbours(cut)) / rms(without_mean(cut.value));
  return roughness >= least_rough ? std::optional(roughness) : std::nullopt;
}

// What the samples of a series show inside of a window.
SensorLimits limits_of(const TimeSeries& cut, TimeWindow window) {
  if (cut.value.empty()) return {};
  const double range = range_of(cut.value);
  if (!(range > 0)) return {};
  const std::optional<double> step = step_of(cut.value);
  const Isolated isolated = IsolatedSearch(cut, range).found();
  const TimeSeries joined = without(isolated.is_isolated, cut);
  return {range,
          step,
          flat_crest(joined, step.value_or(0), window),
          flat_trough(joined, step.value_or(0), window),
          step ? std::nullopt : sparse_readings(cut, range),
          step ? std::nullopt : isolated.told,
          {},
          roughness_of(cut)};
}

// The samples inside of a window; none where one of them is not finite.
TimeSeries finite_part(const TimeSeries& whole, TimeWindow window) {
  TimeSeries part{whole.name, whole.unit, {}, {}};
  for (std::size_t i = 0; i < whole.time.size(); ++i) {
    if (!(whole.time[i] >= window.begin && whole.time[i] <= window.end)) continue;
    if (!std::isfinite(whole.value[i])) return {whole.name, whole.unit, {}, {}};
    part.time.push_back(whole.time[i]);
    part.value.push_back(whole.value[i]);
  }
  return part;
}

}  // namespace

SensorLimits sensor_limits(const TimeSeries& whole, TimeWindow window) {
  TimeSeries part = finite_part(whole, window);
  SensorLimits limits = limits_of(part, window);
  if (!limits.step && !limits.sparse && !limits.isolated) limits.lost = lost_stretches(part);
  const bool is_told = limits.step || limits.highest || limits.lowest || limits.sparse ||
                       limits.isolated || limits.lost || limits.roughness;
  if (!is_told) limits.growth = growth_of_departures(part);
  const double length = window.end - window.begin;
  for (const double around : {length, std::numeric_limits<double>::infinity()}) {
    TimeSeries more = finite_part(whole, {window.begin - around, window.end + around});
    if (more.time.size() == part.time.size()) continue;  // they show the same
    part = std::move(more);
    const SensorLimits wider = limits_of(part, window);
    if (!limits.highest) limits.highest = wider.highest;
    if (!limits.lowest) limits.lowest = wider.lowest;
    const bool is_short = wider.sparse && length < 2 * fewest_readings * wider.sparse->interval;
    if (!limits.sparse && !limits.step && is_short) limits.sparse = wider.sparse;
  }
  return limits;
}

}  // namespace slosh
