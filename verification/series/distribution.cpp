#include "verification/series/distribution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace slosh {
namespace {

constexpr std::size_t fewest_for_interval = 20;  // 1 / 5 %

double count(std::ptrdiff_t n) { return static_cast<double>(n); }

}  // namespace

Distribution::Distribution(std::string name, std::vector<double> values)
    : name_(std::move(name)), sorted_(std::move(values)) {
  if (sorted_.empty()) throw ComparisonError(name_ + ": no values; expected at least one");
  for (std::size_t i = 0; i < sorted_.size(); ++i) {
    if (!std::isfinite(sorted_[i])) {
      throw ComparisonError(fmt::format("{}: value {} of {} is not finite: {}", name_, i + 1,
                                        sorted_.size(), sorted_[i]));
    }
  }
  std::sort(sorted_.begin(), sorted_.end());
}

double Distribution::mean() const {
  return std::accumulate(sorted_.begin(), sorted_.end(), 0.0) / static_cast<double>(sorted_.size());
}

double Distribution::standard_deviation() const {
  if (sorted_.size() < 2)
    throw ComparisonError(name_ + ": a single value has no standard deviation");
  const double m = mean();
  double sum = 0;
  for (const double x : sorted_) sum += (x - m) * (x - m);
  return std::sqrt(sum / static_cast<double>(sorted_.size() - 1));
}

double Distribution::quantile(double probability) const {
  if (!(probability >= 0 && probability <= 1)) {
    throw ComparisonError(
        fmt::format("{}: quantile of {}: expected a number from 0 to 1", name_, probability));
  }
  const double place = probability * static_cast<double>(sorted_.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted_.size() - 1);
  return std::lerp(sorted_[below], sorted_[above], place - static_cast<double>(below));
}

double Distribution::percentile(double x) const {
  if (std::isnan(x)) throw ComparisonError(name_ + ": percentile of NaN: expected a number");
  const auto [first, last] = std::equal_range(sorted_.begin(), sorted_.end(), x);
  return 100 * (count(first - sorted_.begin()) + 0.5 * count(last - first)) /
         static_cast<double>(sorted_.size());
}

Interval Distribution::central_90_percent() const {
  if (sorted_.size() < fewest_for_interval) {
    throw ComparisonError(fmt::format("{}: {} values; its central 90 % needs at least {}", name_,
                                      sorted_.size(), fewest_for_interval));
  }
  return {.low = quantile(0.05), .high = quantile(0.95)};
}

}  // namespace slosh
