#include "verification/gate/distributions/two_sample_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "verification/series/sample_moments.hpp"

namespace slosh {
namespace {

double sum_of(const std::vector<int>& counts) {
  return static_cast<double>(std::accumulate(counts.begin(), counts.end(), 0L));
}

double squared(double x) { return x * x; }

}  // namespace

PooledSamples::PooledSamples(const std::vector<Distribution>& samples) {
  std::vector<double> all;
  for (const Distribution& sample : samples)
    all.insert(all.end(), sample.sorted().begin(), sample.sorted().end());
  std::sort(all.begin(), all.end());
  size_ = all.size();
  for (const double value : all) {
    if (values_.empty() || value != values_.back()) {
      values_.push_back(value);
      counts_.push_back(0);
    }
    ++counts_.back();
    places_.push_back(values_.size() - 1);
  }
  const double n = static_cast<double>(size_);
  double before = 0;
  for (const int l : counts_) {
    const double b = before + 0.5 * l, spread = b * (n - b) - n * l / 4;
    below_.push_back(b);
    weight_.push_back(spread > 0 ? l / n / spread : 0);  // zero where all values are equal
    before += l;
  }
}

std::vector<int> PooledSamples::counts_of(const Distribution& sample) const {
  std::vector<int> counts(values_.size());
  for (const double value : sample.sorted())
    ++counts[static_cast<std::size_t>(std::lower_bound(values_.begin(), values_.end(), value) -
                                      values_.begin())];
  return counts;
}

double PooledSamples::kolmogorov_smirnov(const std::vector<int>& counts) const {
  const double n = static_cast<double>(size_), own = sum_of(counts);
  double up_to = 0, all_up_to = 0, largest = 0;
  for (std::size_t j = 0; j < counts.size(); ++j) {
    up_to += counts[j];
    all_up_to += counts_[j];
    // n_1 n_2 (F_1 - F_2): whole numbers, so that equal statistics are equal to the bit
    largest = std::max(largest, std::abs(n * up_to - own * all_up_to));
  }
  return largest / (own * (n - own));
}

double PooledSamples::anderson_darling_sum(const std::vector<int>& counts) const {
  const double n = static_cast<double>(size_), own = sum_of(counts);
  double before = 0, sum = 0;
  for (std::size_t j = 0; j < counts.size(); ++j) {
    const double m = before + 0.5 * counts[j];
    sum += weight_[j] * squared(n * m - own * below_[j]);
    before += counts[j];
  }
  return sum;
}

// The difference N M - n B of the others is that of the sample with the other sign.
double PooledSamples::anderson_darling(const std::vector<int>& counts) const {
  const double n = static_cast<double>(size_), own = sum_of(counts);
  return (n - 1) / n * (1 / own + 1 / (n - own)) * anderson_darling_sum(counts);
}

double PooledSamples::anderson_darling(const std::vector<Distribution>& samples) const {
  const double n = static_cast<double>(size_);
  double sum = 0;
  for (const Distribution& sample : samples)
    sum += anderson_darling_sum(counts_of(sample)) / static_cast<double>(sample.sorted().size());
  return (n - 1) / n * sum;
}

double welch_p_value(const Distribution& one, const Distribution& other) {
  const auto of_mean = [](const Distribution& sample) {
    return squared(sample.standard_deviation()) / static_cast<double>(sample.sorted().size());
  };
  const auto freedom = [](const Distribution& sample) {
    return static_cast<double>(sample.sorted().size()) - 1;
  };
  const double a = of_mean(one), b = of_mean(other), difference = one.mean() - other.mean();
  if (a + b == 0) return difference == 0 ? 1 : 0;
  const double degrees = squared(a + b) / (a * a / freedom(one) + b * b / freedom(other));
  return two_sided_p(difference / std::sqrt(a + b), degrees);
}

}  // namespace slosh
