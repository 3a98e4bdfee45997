#include "verification/gate/distributions/permutation_test.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slosh {
namespace {

constexpr double rounding = 1e-12;  // relative: two orders of one sum differ by less

// Calls `use` with the statistic of each division, the first sample's size as it is.
template <class Use>
void divide(const PooledSamples& pooled, std::size_t size_of_first,
            const TwoSampleStatistic& statistic, const SeededTrials& divisions, Use use) {
  SeededDraws draws(divisions.seed);
  std::vector<std::size_t> places = pooled.places();
  for (int k = 0; k < divisions.count; ++k) {
    std::vector<int> counts(pooled.values().size());
    for (std::size_t i = 0; i < size_of_first; ++i) {
      std::swap(places[i], places[i + draws.below(places.size() - i)]);
      ++counts[places[i]];
    }
    use(statistic(pooled, counts));
  }
}

// The larger distance of Wilson's interval of b of n from the p-value.
double half_width(double p, double b, double n) {
  constexpr double z = 1.96;
  const double share = b / n, middle = (share + z * z / (2 * n)) / (1 + z * z / n);
  const double half =
      z / (1 + z * z / n) * std::sqrt(share * (1 - share) / n + z * z / (4 * n * n));
  return std::max(p - (middle - half), middle + half - p);
}

}  // namespace

double kolmogorov_smirnov_statistic(const PooledSamples& pooled, const std::vector<int>& counts) {
  return pooled.kolmogorov_smirnov(counts);
}

double anderson_darling_statistic(const PooledSamples& pooled, const std::vector<int>& counts) {
  return pooled.anderson_darling(counts);
}

Estimate permutation_p_value(const Distribution& one, const Distribution& other,
                             const TwoSampleStatistic& statistic, const SeededTrials& divisions) {
  const PooledSamples pooled({one, other});
  const double reached = statistic(pooled, pooled.counts_of(one)) * (1 - rounding);
  int as_large = 0;
  divide(pooled, one.sorted().size(), statistic, divisions,
         [&](double value) { as_large += value >= reached ? 1 : 0; });
  const double p = (as_large + 1.0) / (divisions.count + 1.0);
  return {p, half_width(p, as_large, divisions.count)};
}

}  // namespace slosh
