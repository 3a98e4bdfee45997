#include "verification/series/readings/lost_share.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "verification/series/sample_moments.hpp"

namespace slosh {
namespace {

constexpr std::size_t beside = 4, least_wave = 12, usual_wave = 24, fewest_judged_waves = 4;
constexpr double fewest_judged = 320, least_growth = 1.5, growth_by_chance = 9;
constexpr double far_from_mean = 0.7, near_mean = 0.3;  // of a crest or trough
constexpr double least_departure = 0.02;                // of the standard deviation
constexpr double least_white = 0.65, most_white = 1.12, most_of_between = 2.4, least_far = 1.8;

template <std::size_t N>
double difference(const double* middle, const std::array<double, N>& weights) {
  const double sum = std::inner_product(weights.begin(), weights.end(), middle - N / 2, 0.0);
  return std::abs(sum) /
         std::sqrt(std::inner_product(weights.begin(), weights.end(), weights.begin(), 0.0));
}

struct Departures {
  double sum = 0, count = 0;
  void add(double one) { sum += one, ++count; }
  double mean() const { return sum / count; }
};

}  // namespace

std::optional<double> growth_of_departures(const TimeSeries& series) {
  const std::vector<double> value = without_mean(series.value);
  std::vector<double> course(value.size()), sixth(course), eighth(course);
  for (std::size_t i = beside; i + beside < value.size(); ++i) {
    course[i] = mean({&value[i - 3], &value[i + 4]});
    sixth[i] = difference<7>(&value[i], {1, -6, 15, -20, 15, -6, 1});
    eighth[i] = difference<9>(&value[i], {1, -8, 28, -56, 70, -56, 28, -8, 1});
  }
  Departures crest, trough, between, near, far_eighth;
  std::vector<double> lengths, far;
  std::size_t first = 0;
  for (std::size_t i = beside + 1; i + beside < value.size(); ++i) {
    if (course[i - 1] >= 0 || course[i] < 0 || (first > 0 && i - first < least_wave)) continue;
    const std::size_t begin = std::exchange(first, i);
    const auto [low, high] = std::minmax_element(&course[begin], &course[i]);
    const double scale = mean({&sixth[begin], &sixth[i]});
    if (begin == 0 || !(scale > 0)) continue;
    lengths.push_back(static_cast<double>(i - begin));
    for (std::size_t k = begin; k < i; ++k) {
      const bool at_crest = course[k] >= far_from_mean * *high;
      const bool at_trough = course[k] <= far_from_mean * *low;
      const bool at_mean = course[k] <= near_mean * *high && course[k] >= near_mean * *low;
      (at_crest ? crest : at_trough ? trough : at_mean ? near : between).add(sixth[k] / scale);
      if (at_crest || at_trough) far.push_back(sixth[k]), far_eighth.add(eighth[k] / scale);
    }
  }
  const double count = crest.count + trough.count + between.count + near.count;
  if (lengths.size() < fewest_judged_waves || count < fewest_judged) return std::nullopt;
  const double far_mean = (crest.sum + trough.sum) / far_eighth.count;
  const double white = far_eighth.mean() / far_mean;
  // Near the mean they may be on a line; then a large number is told, and no infinity.
  const double growth = std::min(std::min(crest.mean(), trough.mean()) / near.mean(), 100.0);
  const bool is_told = median(lengths) >= usual_wave &&
                       median(far) >= least_departure * rms(value) && white >= least_white &&
                       white <= most_white && far_eighth.count >= least_far * near.count &&
                       far_mean <= most_of_between * between.mean() &&
                       growth >= least_growth + growth_by_chance / std::sqrt(count);
  return is_told ? std::optional(growth) : std::nullopt;
}

}  // namespace slosh
