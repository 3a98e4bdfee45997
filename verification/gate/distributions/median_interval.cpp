#include "verification/gate/distributions/median_interval.hpp"

#include <array>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>

#include "verification/series/time_series.hpp"

namespace slosh {
namespace {

constexpr double confidence = 0.95;
constexpr std::array<double, 6> ranges_to_either_side{not_a_number, not_a_number, 6.353,
                                                      1.342,        0.7385,       0.560};

// How often the median lies between the k-th of n values and the k-th from their other end.
double coverage(std::size_t n, std::size_t k) {
  const boost::math::binomial below(static_cast<double>(n), 0.5);
  return 1 - 2 * boost::math::cdf(below, static_cast<double>(k) - 1);
}

Interval between_sorted(const std::vector<double>& x) {
  const std::size_t n = x.size();
  std::size_t k = 1;
  while (coverage(n, k + 1) >= confidence) ++k;
  const double part = (coverage(n, k) - confidence) / (coverage(n, k) - coverage(n, k + 1));
  const double outer = static_cast<double>(k), all = static_cast<double>(n);
  const double inwards = (all - outer) * part / (outer + (all - 2 * outer) * part);
  return {.low = std::lerp(x[k - 1], x[k], inwards),
          .high = std::lerp(x[n - k], x[n - k - 1], inwards)};
}

}  // namespace

Interval median_interval(const Distribution& sample) {
  const std::vector<double>& x = sample.sorted();
  if (x.size() >= ranges_to_either_side.size()) return between_sorted(x);
  const double half = ranges_to_either_side[x.size()] * (x.back() - x.front());
  const double median = sample.quantile(0.5);
  return {.low = median - half, .high = median + half};
}

}  // namespace slosh
