#include "verification/metrics/cross_correlation.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

using Eigen::Index, Eigen::VectorXd;

VectorXd eigen_vector(std::vector<double> values) {
  remove_trend(values);
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size()));
}

double correlation(const VectorXd& candidate, const VectorXd& reference, Index lag) {
  const Index overlap = reference.size() - std::abs(lag);
  const auto c = candidate.segment(std::max<Index>(lag, 0), overlap),
             r = reference.segment(std::max<Index>(-lag, 0), overlap);
  return c.dot(r) / std::sqrt(c.squaredNorm() * r.squaredNorm());
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
  const VectorXd late = eigen_vector(interpolate(c, times)),
                 early = eigen_vector(interpolate(r, times));

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

}  // namespace slosh
