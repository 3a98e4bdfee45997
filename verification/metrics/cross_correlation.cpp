#include "verification/metrics/cross_correlation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verification/metrics/windowed_series.hpp"

namespace slosh {
namespace {

double correlation(const std::vector<double>& candidate, const std::vector<double>& reference,
                   int lag) {
  const int count = static_cast<int>(reference.size());
  double product = 0, candidate_energy = 0, reference_energy = 0;
  for (int i = std::max(0, -lag); i < std::min(count, count - lag); ++i) {
    const double c = candidate[i + lag], r = reference[i];
    product += c * r;
    candidate_energy += c * c;
    reference_energy += r * r;
  }
  return product / std::sqrt(candidate_energy * reference_energy);
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
  std::vector<double> late = interpolate(c, times), early = interpolate(r, times);
  remove_trend(late);
  remove_trend(early);

  const double interval = times[1] - times[0];
  const int most = static_cast<int>(std::ceil(0.5 * period / interval)) - 1;
  std::vector<double> correlations;
  for (int lag = -most; lag <= most; ++lag) correlations.push_back(correlation(late, early, lag));
  const auto top = std::max_element(correlations.begin(), correlations.end());
  const double lag = static_cast<double>(top - correlations.begin() - most);
  if (top == correlations.begin() || top == correlations.end() - 1) return lag * interval;
  const double left = *(top - 1), right = *(top + 1);
  return (lag + 0.5 * (left - right) / (left - 2 * *top + right)) * interval;
}

}  // namespace slosh
