#include "verification/series/sensor_limits.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "verification/series/sample_moments.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

constexpr int most_steps = 100;
constexpr double on_levels = 0.9;                                 // of the samples
constexpr double off_level = 0.01;                                // [steps] by rounding
constexpr double least_hidden = 0.015;                            // of the range
constexpr double bands[] = {1e-3, 3e-3, 0.01, 0.02, 0.04, 0.08};  // of the range
constexpr double most_of_round = 0.2;  // of what a round crest falls by inside
constexpr double standard_errors = 2.5;
constexpr double same_line = 1e-5;  // of the range, by rounding
constexpr std::size_t fewest_readings = 6;
constexpr std::size_t most_sampled = 20000, fewest_in_flat = 3, fewest_fitted = 6;

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

// By the straight line between the samples.
double value_at(const TimeSeries& series, double time) {
  const auto after = std::lower_bound(series.time.begin(), series.time.end(), time);
  const auto i = static_cast<std::size_t>(after - series.time.begin());
  const double share = (time - series.time[i - 1]) / (series.time[i] - series.time[i - 1]);
  return std::lerp(series.value[i - 1], series.value[i], share);
}

// The samples of a crest that lie within a band of the extreme.
struct Top {
  FlatExtreme flat;
  double fall, variance;  // of the parabola through them, from its middle to its ends
};

// By least squares; the whole band and no variance of few samples.
void fit_parabola(const TimeSeries& series, std::size_t first, std::size_t last, double band,
                  Top& top) {
  const std::size_t count = last - first + 1;
  top.fall = band;
  top.variance = 0;
  if (count < fewest_fitted) return;
  const double middle = (top.flat.begin + top.flat.end) / 2, half = top.flat.end - middle;
  Eigen::MatrixX3d powers(count, 3);
  Eigen::VectorXd values(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = (series.time[first + i] - middle) / half;
    const auto row = static_cast<Eigen::Index>(i);
    powers.row(row) << 1, x, x * x;
    values[row] = series.value[first + i] - top.flat.value;
  }
  const Eigen::Matrix3d inverse = (powers.transpose() * powers).inverse();
  const Eigen::Vector3d found = inverse * (powers.transpose() * values);
  top.fall = std::abs(found[2]);
  top.variance =
      (values - powers * found).squaredNorm() / static_cast<double>(count - 3) * inverse(2, 2);
}

// Whose edges lie between the samples from first to last and their neighbours; nullopt where it
// reaches an end of the series.
std::optional<Top> top_of(const TimeSeries& series, double band, std::size_t first,
                          std::size_t last) {
  const std::vector<double>& time = series.time;
  if (first == 0 || last + 1 == time.size()) return std::nullopt;
  const double begin = (time[first - 1] + time[first]) / 2, end = (time[last] + time[last + 1]) / 2,
               half = (end - begin) / 2;
  if (begin - half <= time.front() || end + half >= time.back()) return std::nullopt;
  const std::vector<double> inside(series.value.begin() + static_cast<std::ptrdiff_t>(first),
                                   series.value.begin() + static_cast<std::ptrdiff_t>(last + 1));
  const double middle = median(inside);
  const double drop = std::min(std::abs(value_at(series, begin - half) - middle),
                               std::abs(value_at(series, end + half) - middle));
  Top top{{middle, begin, end, drop / 3}, 0, 0};
  fit_parabola(series, first, last, band, top);
  return top;
}

// The flat that hides most, where all crests that reach the band are flat together. Within a step
// of the sensor nothing is known of their fall.
std::optional<FlatExtreme> flat_within(const TimeSeries& series, double extreme, double band,
                                       double range, double step) {
  std::optional<FlatExtreme> worst;
  double hidden = 0, fall = 0, variance = 0;
  for (std::size_t i = 0; i < series.value.size(); ++i) {
    const std::size_t first = i;
    while (i < series.value.size() && std::abs(series.value[i] - extreme) <= band) ++i;
    if (i - first < fewest_in_flat) continue;
    const std::optional<Top> top = top_of(series, band, first, i - 1);
    if (!top || top->flat.hidden < least_hidden * range) continue;
    hidden += top->flat.hidden;
    fall += std::max(top->fall, step);
    variance += top->variance;
    if (!(worst && worst->hidden >= top->flat.hidden)) worst = top->flat;
  }
  const bool is_flat = fall + standard_errors * std::sqrt(variance) <= most_of_round * hidden;
  return is_flat ? worst : std::nullopt;
}

std::optional<FlatExtreme> flat_extreme(const TimeSeries& series, double extreme, double range,
                                        double step) {
  for (const double band : bands)
    if (auto flat = flat_within(series, extreme, band * range, range, step)) return flat;
  return std::nullopt;
}

// The samples from which on the values move by another slope, and by how much it differs.
struct Knots {
  std::vector<double> interval, turn;
};

// Of straight lines, or of the values themselves where these are held.
Knots knots_of(const TimeSeries& series, double range, bool held) {
  const std::vector<double>&time = series.time, &value = series.value;
  Knots knots;
  double last = 0;
  bool is_first = true;
  for (std::size_t i = 1; i + 1 < value.size(); ++i) {
    const double before = held ? 0 : (value[i] - value[i - 1]) / (time[i] - time[i - 1]);
    const double step = time[i + 1] - time[i];
    const double left = value[i + 1] - value[i] - before * step;  // by which it leaves the line
    if (std::abs(left) <= same_line * range) continue;
    if (!is_first) {
      knots.interval.push_back(time[i] - last);
      knots.turn.push_back(std::abs(left) / (held ? 1 : step));
    }
    last = time[i];
    is_first = false;
  }
  return knots;
}

std::optional<SparseReadings> sparse_readings(const TimeSeries& series, double range) {
  for (const bool held : {true, false}) {
    const Knots knots = knots_of(series, range, held);
    if (knots.interval.size() < fewest_readings) continue;
    const double interval = median(knots.interval);
    const double turn = median(knots.turn);
    const double hidden = held ? turn / 2 : turn * interval / 8;
    if (interval >= 1.5 * median_sample_interval(series.time) && hidden >= least_hidden * range)
      return SparseReadings{held, interval, hidden};
  }
  return std::nullopt;
}

}  // namespace

SensorLimits sensor_limits(const TimeSeries& cut) {
  if (cut.value.empty()) return {};
  const auto [low, high] = std::minmax_element(cut.value.begin(), cut.value.end());
  const double range = *high - *low;
  if (!(range > 0)) return {};
  const std::optional<double> step = step_of(cut.value);
  return {range, step, flat_extreme(cut, *high, range, step.value_or(0)),
          flat_extreme(cut, *low, range, step.value_or(0)),
          step ? std::nullopt : sparse_readings(cut, range)};
}

}  // namespace slosh
