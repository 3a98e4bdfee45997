#include "verification/metrics/ensemble_mean.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "verification/series/sample_moments.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {
namespace {

// The variance of a side's mean and its degrees of freedom; both are zero for a side of one run.
struct MeanVariance {
  double variance = 0, freedom = 0;
};

MeanVariance variance_of_mean(const std::vector<double>& values, double least_deviation) {
  if (values.size() < 2) return {};
  const double n = static_cast<double>(values.size());
  const double deviation = rms(without_mean(values)), least = least_deviation * least_deviation / n;
  const double variance = deviation * deviation / (n - 1);
  return {std::isnan(least) || least > variance ? least : variance, n - 1};
}

// The variance of the difference between this mean and one more run: s^2 / n + s^2.
MeanVariance with_one_of_many(const MeanVariance& mean) {
  return {mean.variance * (mean.freedom + 2), mean.freedom};
}

double welch_freedom(const MeanVariance& a, const MeanVariance& b) {
  const auto part = [](const MeanVariance& one) {
    return one.freedom > 0 ? one.variance * one.variance / one.freedom : 0;
  };
  const double sum = a.variance + b.variance;
  return sum * sum / (part(a) + part(b));
}

double half_width_of(double variance, double freedom) {
  if (variance == 0) return 0;  // all members are equal
  if (!std::isfinite(variance)) return not_a_number;
  return t95(freedom) * std::sqrt(variance);
}

// Runs that scatter by so little beside their own intervals are one run, as copies of it are. The
// half width is that of their mean.
double with_own(double half_width, std::size_t runs, double own) {
  constexpr double alike = 0.1;
  const double of_one = half_width * std::sqrt(static_cast<double>(runs));
  return of_one < alike * own ? std::hypot(half_width, own) : half_width;
}

}  // namespace

Estimate ensemble_mean(const std::vector<std::vector<Estimate>>& pairs, SingleSide single,
                       const LeastDeviations& least) {
  if (pairs.empty() || pairs.front().empty() || pairs.size() * pairs.front().size() < 2)
    throw std::invalid_argument("an ensemble's mean needs two runs or more");
  std::vector<double> of_candidates(pairs.size()), of_references(pairs.front().size()), own;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (std::size_t j = 0; j < of_references.size(); ++j) {
      of_candidates[i] += pairs[i][j].value / static_cast<double>(of_references.size());
      of_references[j] += pairs[i][j].value / static_cast<double>(pairs.size());
      own.push_back(pairs[i][j].half_width);
    }
  const MeanVariance a = variance_of_mean(of_candidates, least.candidates),
                     b = variance_of_mean(of_references, least.references);
  const double value = mean(of_candidates);
  const std::size_t runs = std::max(pairs.size(), of_references.size());
  if (a.freedom > 0 && b.freedom > 0)
    return {value,
            with_own(half_width_of(a.variance + b.variance, welch_freedom(a, b)), runs, mean(own))};
  const MeanVariance repeated = a.freedom > 0 ? a : b;
  if (single == SingleSide::exact)
    return {value, with_own(half_width_of(repeated.variance, repeated.freedom), runs, mean(own))};
  const MeanVariance one_more = with_one_of_many(repeated);
  return {value, std::hypot(half_width_of(one_more.variance, one_more.freedom), mean(own))};
}

Estimate mean_of_members(const std::vector<double>& numbers) {
  if (numbers.size() == 1) return {numbers.front(), 0};
  std::vector<std::vector<Estimate>> pairs;
  for (const double one : numbers) pairs.push_back({{one, 0}});
  return ensemble_mean(pairs, SingleSide::exact);
}

}  // namespace slosh
