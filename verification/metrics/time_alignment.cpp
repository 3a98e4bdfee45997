#include "verification/metrics/time_alignment.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>

#include "verification/series/time_series.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

using Eigen::Index, Eigen::VectorXd;

VectorXd detrended(std::vector<double> values) {
  remove_trend(values);
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size()));
}

double correlation(const VectorXd& candidate, const VectorXd& reference, Index lag) {
  const Index overlap = reference.size() - std::abs(lag);
  const auto c = candidate.segment(std::max<Index>(lag, 0), overlap),
             r = reference.segment(std::max<Index>(-lag, 0), overlap);
  return c.dot(r) / std::sqrt(c.squaredNorm() * r.squaredNorm());
}

constexpr double largest_lag_of_span = 0.25;
constexpr int trial_lags = 200;  // a hundredth of the range apart, then refined
constexpr int bits = 26;         // of the lag: half a double's, as for any minimum

// The normalised error at a lag; integrals by the trapezoidal rule.
double error_at_lag(const TimeSeries& candidate, const TimeSeries& reference, double lag) {
  std::vector<double> late, r, t;
  for (std::size_t i = 0; i < reference.time.size(); ++i) {
    const double at = reference.time[i] + lag;
    if (at < candidate.time.front() || at > candidate.time.back()) continue;
    late.push_back(at);
    t.push_back(reference.time[i]);
    r.push_back(reference.value[i]);
  }
  const std::vector<double> c = interpolate(candidate, late);
  double length = 0, sum = 0, sum2 = 0, difference2 = 0;
  for (std::size_t i = 1; i < t.size(); ++i) {
    const double half = 0.5 * (t[i] - t[i - 1]);
    length += 2 * half;
    sum += half * (r[i] + r[i - 1]);
    sum2 += half * (r[i] * r[i] + r[i - 1] * r[i - 1]);
    difference2 += half * (std::pow(c[i] - r[i], 2) + std::pow(c[i - 1] - r[i - 1], 2));
  }
  return std::sqrt(difference2 / (sum2 - sum * sum / length));
}

}  // namespace

double cross_correlation_lag(const TimeSeries& candidate, const TimeSeries& reference,
                             TimeWindow window, double period) {
  const TimeSeries c = cut_to_window(candidate, window), r = cut_to_window(reference, window);
  require_variation(c);
  require_variation(r);
  const double begin = std::max(c.time.front(), r.time.front());
  const double end = std::min(c.time.back(), r.time.back());
  if (!(end - begin >= period)) {
    throw ComparisonError(
        fmt::format("{}: overlap of {:.4g} s; the cross-correlation needs one period, {:.4g} s",
                    reference.name, end - begin, period));
  }
  const auto times = uniform_times(begin, end, r.time.size());
  const VectorXd late = detrended(interpolate(c, times)), early = detrended(interpolate(r, times));

  const double interval = times[1] - times[0];
  const int most = static_cast<int>(std::ceil(0.5 * period / interval)) - 1;
  std::vector<double> correlations;
  for (Index lag = -most; lag <= most; ++lag) correlations.push_back(correlation(late, early, lag));
  const auto top = std::max_element(correlations.begin(), correlations.end());
  const double lag = static_cast<double>(top - correlations.begin() - most);
  if (top == correlations.begin() || top == correlations.end() - 1) return lag * interval;
  const double left = *(top - 1), right = *(top + 1);
  return (lag + 0.5 * (left - right) / (left - 2 * *top + right)) * interval;
}

TimeAlignment align_in_time(const TimeSeries& candidate, const TimeSeries& reference) {
  const double range = largest_lag_of_span * (reference.time.back() - reference.time.front());
  const double step = 2 * range / trial_lags;
  const auto error = [&](double lag) { return error_at_lag(candidate, reference, lag); };
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= trial_lags; ++i) {
    const double found = error(-range + i * step);
    if (!(found < least)) continue;
    least = found;
    best = i;
  }
  if (best == 0 || best == trial_lags) return {not_a_number, not_a_number};
  const auto [lag, rms] = boost::math::tools::brent_find_minima(error, -range + (best - 1) * step,
                                                                -range + (best + 1) * step, bits);
  return {lag, rms};
}

}  // namespace slosh
