#include "verification/metrics/time_alignment.hpp"

#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>

#include "verification/series/estimate.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

constexpr double largest_lag_of_span = 0.25;
constexpr int trial_lags = 200;  // a hundredth of the range apart, then refined
constexpr int bits = 26;         // of the lag, all that the least of a parabola can tell

// Integrals by the trapezoidal rule.
double normalised_rms(const TimeSeries& candidate, const TimeSeries& reference, double lag) {
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

TimeAlignment align_in_time(const TimeSeries& candidate, const TimeSeries& reference) {
  const double range = largest_lag_of_span * (reference.time.back() - reference.time.front());
  const double step = 2 * range / trial_lags;
  const auto error = [&](double lag) { return normalised_rms(candidate, reference, lag); };
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
