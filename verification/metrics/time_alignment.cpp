#include "verification/metrics/time_alignment.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "verification/series/fourier_transform.hpp"
#include "verification/series/time_series.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

using Eigen::Index, Eigen::VectorXd;

VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size()));
}

VectorXd detrended(std::vector<double> values) {
  remove_trend(values);
  return vector_of(values);
}

// Sums over the samples i at which both c_{i + lag} and r_i exist.
struct OverlapSums {
  double candidate, reference, product;  // of c^2, r^2 and c r
  double value, count;                   // of r and of 1
};

// The sums over the overlap for all lags at once: the products by Fourier transforms, the rest as
// differences of running sums. `first` is the place of the candidate's first sample.
class SumsByLag {
 public:
  SumsByLag(const VectorXd& candidate, Index first, const VectorXd& reference)
      : first_(first),
        candidate_(running(candidate.cwiseAbs2())),
        reference_(running(reference.cwiseAbs2())),
        values_(running(reference)) {
    const Index length = fast_length(candidate.size() + reference.size());
    const Eigen::VectorXcd of_candidate = fourier_transforms(candidate, length),
                           of_reference = fourier_transforms(reference, length);
    products_ =
        inverse_fourier_transform(of_candidate.cwiseProduct(of_reference.conjugate()), length);
  }

  OverlapSums at(Index lag) const {
    const Index samples = candidate_.size() - 1, place = lag - first_;  // of r_0 in the candidate
    const Index begin = std::max<Index>(0, -place),
                end = std::min(reference_.size() - 1, samples - place);
    if (end <= begin) return {};
    const Index length = products_.size();
    return {candidate_[end + place] - candidate_[begin + place],
            reference_[end] - reference_[begin], products_[(place + length) % length],
            values_[end] - values_[begin], static_cast<double>(end - begin)};
  }

 private:
  static VectorXd running(const VectorXd& values) {
    VectorXd sums(values.size() + 1);
    double sum = 0;
    for (Index i = 0; i < values.size(); ++i) {
      sums[i] = sum;
      sum += values[i];
    }
    sums[values.size()] = sum;
    return sums;
  }

  Index first_;
  VectorXd candidate_, reference_, values_, products_;
};

// How much the lags -most ... most of one sample each lack of a perfect match: 1 - correlation, or
// half the square of the normalised error. Not finite where a lag has none.
struct Deficits {
  std::vector<double> of_lag;

  template <class Deficit>
  Deficits(Index most, const Deficit& deficit) {
    for (Index lag = -most; lag <= most; ++lag) of_lag.push_back(deficit(lag));
  }
  std::size_t most() const { return of_lag.size() / 2; }
  bool at_end(std::size_t i) const { return i == 0 || i + 1 == of_lag.size(); }

  // The minimum of the parabola through the i-th deficit and its neighbours, in samples from it.
  double offset(std::size_t i) const {
    if (at_end(i)) return 0;
    const double left = of_lag[i - 1], here = of_lag[i], right = of_lag[i + 1];
    const double offset = 0.5 * (left - right) / (left - 2 * here + right);
    return std::abs(offset) <= 1 ? offset : 0;
  }
  double bottom(std::size_t i) const {
    if (at_end(i)) return of_lag[i];
    return of_lag[i] - 0.25 * (of_lag[i - 1] - of_lag[i + 1]) * offset(i);
  }
};

// Two minima are apart where the deficit between them rises this far above the least. Ten samples
// in a period leave up to 0.05 at the top of a peak.
constexpr double rise_between = 0.2;
// Minima up to this far above the least, or up to a tenth of it, are as good as the least.
constexpr double as_good = 1e-3, as_good_share = 0.1;

// The lowest place of each stretch of nearly the least deficits.
std::vector<std::size_t> minima_of(const Deficits& deficits) {
  const std::vector<double>& of_lag = deficits.of_lag;
  double least = std::numeric_limits<double>::infinity();
  for (const double deficit : of_lag)
    if (deficit < least) least = deficit;
  std::vector<std::size_t> minima;
  bool inside = false;
  for (std::size_t i = 0; i < of_lag.size(); ++i) {
    const bool was_inside = std::exchange(inside, of_lag[i] < least + rise_between);
    if (!inside) continue;
    if (!was_inside)
      minima.push_back(i);
    else if (of_lag[i] < of_lag[minima.back()])
      minima.back() = i;
  }
  return minima;
}

// The place of the lag nearest to zero among those that match best; nullopt where no lag matches.
std::optional<std::size_t> best_lag(const Deficits& deficits) {
  const std::vector<std::size_t> minima = minima_of(deficits);
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t i : minima) least = std::min(least, deficits.bottom(i));
  const auto from_zero = [&](std::size_t i) {
    return std::abs(static_cast<Index>(i) - static_cast<Index>(deficits.most()));
  };
  std::optional<std::size_t> best;
  for (const std::size_t i : minima)
    if (deficits.bottom(i) <= least + as_good + as_good_share * std::abs(least) &&
        (!best || from_zero(i) < from_zero(*best)))
      best = i;
  return best;
}

constexpr double largest_lag_of_span = 0.25, largest_error = 2;
constexpr std::size_t fewest_grid_samples = 401;
// Of the reference, at which the best lag is refined.
constexpr std::size_t most_refined_samples = 200000;
constexpr int bits = 26;  // of the lag: half a double's, as for any minimum

TimeSeries thinned(const TimeSeries& series, std::size_t most) {
  const std::size_t stride = 1 + (series.time.size() - 1) / most;
  TimeSeries few{series.name, series.unit, {}, {}};
  for (std::size_t i = 0; i < series.time.size(); i += stride) {
    few.time.push_back(series.time[i]);
    few.value.push_back(series.value[i]);
  }
  return few;
}

// The normalised error at a lag; integrals by the trapezoidal rule.
double error_at_lag(const Interpolant& candidate, const TimeSeries& reference, double lag) {
  std::vector<double> late, r, t;
  for (std::size_t i = 0; i < reference.time.size(); ++i) {
    const double at = reference.time[i] + lag;
    if (!candidate.holds(at)) continue;
    late.push_back(at);
    t.push_back(reference.time[i]);
    r.push_back(reference.value[i]);
  }
  const std::vector<double> c = candidate.at(late);
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

// Equally spaced times, enough for the samples of both series.
struct LagGrid {
  double begin, interval;
  Index count;

  LagGrid(const TimeSeries& candidate, const TimeSeries& reference) {
    begin = reference.time.front();
    const double span = reference.time.back() - begin;
    const double of_candidate = static_cast<double>(candidate.time.size()) * span /
                                (candidate.time.back() - candidate.time.front());
    count = std::max({static_cast<Index>(fewest_grid_samples), std::ssize(reference.time),
                      static_cast<Index>(of_candidate)});
    interval = span / static_cast<double>(count - 1);
  }

  std::vector<double> times(Index first, Index last, const TimeSeries& within) const {
    std::vector<double> found;
    for (Index k = first; k <= last; ++k)
      found.push_back(std::clamp(begin + static_cast<double>(k) * interval, within.time.front(),
                                 within.time.back()));
    return found;
  }
};

// The squares of the normalised errors, halved, for the lags of the grid.
Deficits error_deficits(const TimeSeries& candidate, const Interpolant& curve,
                        const TimeSeries& reference, const LagGrid& grid) {
  const auto most = static_cast<Index>(largest_lag_of_span * static_cast<double>(grid.count - 1));
  constexpr double rounding = 1e-9;  // of a sample
  const auto place = [&](double time) { return (time - grid.begin) / grid.interval; };
  const Index first = std::max(
                  -most, static_cast<Index>(std::ceil(place(candidate.time.front()) - rounding))),
              last =
                  std::min(grid.count - 1 + most,
                           static_cast<Index>(std::floor(place(candidate.time.back()) + rounding)));
  VectorXd r = vector_of(interpolate(reference, grid.times(0, grid.count - 1, reference)));
  VectorXd c = vector_of(curve.at(grid.times(first, last, candidate)));
  const double datum = r.mean();  // keeps the sums of squares free of cancellation
  r.array() -= datum;
  c.array() -= datum;
  const SumsByLag sums(c, first, r);
  return {most, [&](Index lag) {
            const OverlapSums of = sums.at(lag);
            return 0.5 * (of.candidate - 2 * of.product + of.reference) /
                   (of.reference - of.value * of.value / of.count);
          }};
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
  if (late == early) return 0;

  const double interval = times[1] - times[0];
  const auto most = static_cast<Index>(std::ceil(0.5 * period / interval)) - 1;
  const SumsByLag sums(late, 0, early);
  const Deficits deficits(most, [&](Index lag) {
    const OverlapSums of = sums.at(lag);
    return 1 - of.product / std::sqrt(of.candidate * of.reference);
  });
  const auto least = std::min_element(deficits.of_lag.begin(), deficits.of_lag.end());
  const auto best = static_cast<std::size_t>(least - deficits.of_lag.begin());
  return (static_cast<double>(best) - static_cast<double>(most) + deficits.offset(best)) * interval;
}

TimeAlignment align_in_time(const TimeSeries& candidate, const TimeSeries& reference) {
  const Interpolant curve(candidate);
  const LagGrid grid(candidate, reference);
  const Deficits deficits = error_deficits(candidate, curve, reference, grid);
  const auto best = best_lag(deficits);
  if (!best || deficits.at_end(*best) ||
      deficits.of_lag[*best] > 0.5 * largest_error * largest_error)
    return {not_a_number, not_a_number};
  const TimeSeries few = thinned(reference, most_refined_samples);
  const double near =
      (static_cast<double>(*best) - static_cast<double>(deficits.most())) * grid.interval;
  const auto [lag, error] = boost::math::tools::brent_find_minima(
      [&](double trial) { return error_at_lag(curve, few, trial); }, near - grid.interval,
      near + grid.interval, bits);
  if (error_at_lag(curve, few, 0) <= error) return {0, error_at_lag(curve, reference, 0)};
  return {lag, error_at_lag(curve, reference, lag)};
}

}  // namespace slosh
