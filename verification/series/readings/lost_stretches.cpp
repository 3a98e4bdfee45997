#include "verification/series/readings/lost_stretches.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "verification/series/readings/interruption.hpp"
#include "verification/series/sample_moments.hpp"

namespace slosh {
namespace {

constexpr std::size_t most_searched = 100000;
constexpr std::size_t fewest_searched = 40, fewest_stretches = 4, long_stretch = 6;
constexpr double least_lost_share = 0.01;  // of the mean departure from the mean
constexpr double times_usual = 6;          // a quarter of the stretches
constexpr double times_left = 2;           // by the interrupted description, of a sample
constexpr double times_whole = 2, times_once = 1.5, times_lines = 0.5;
constexpr double sigma_whole = 20, sigma_once = 10;  // [variances of the noise]
constexpr double uneven = 1.5;                       // the longest interval over the shortest
constexpr double one_value = 0.015;                  // of the range
constexpr double least_visible = 1e-12;              // of the range

// A series whose samples are each the mean of `group` of the first one.
struct Grouped {
  std::vector<double> time, value;
  std::size_t group;
};

Grouped in_groups(const Grouped& of, std::size_t size) {
  Grouped found{{}, {}, of.group * size};
  for (std::size_t i = 0; i + size <= of.value.size(); i += size) {
    const auto mean_from = [&](const std::vector<double>& all) {
      const auto first = all.begin() + static_cast<std::ptrdiff_t>(i);
      return std::accumulate(first, first + static_cast<std::ptrdiff_t>(size), 0.0) /
             static_cast<double>(size);
    };
    found.time.push_back(mean_from(of.time));
    found.value.push_back(mean_from(of.value));
  }
  return found;
}

struct Stretch {
  double begin, end, departure, value;  // upwards
};

// Of one length of stretch and one length of the sides, in samples.
class Lengths {
 public:
  Lengths(const Grouped& of, std::size_t inside, std::size_t sides, double range)
      : of_(of),
        sides_(sides),
        guard_(of.group > 1 ? 1 : 0),  // a mean over an edge belongs to neither
        least_(least_visible * range),
        interruption_(places(2 * (sides_ + guard_) + inside), sides_, guard_,
                      inside < long_stretch ? Interruption::Degrees{5, 3, 1}
                                            : Interruption::Degrees{6, 4, 1}) {}

  // The stretches that are lost, the one that leaves its curve most first.
  std::vector<Stretch> lost() const {
    const std::size_t size = interruption_.size();
    if (of_.value.size() < size + fewest_stretches) return {};
    std::vector<std::pair<double, std::size_t>> departures;
    for (std::size_t i = 0; i + size <= of_.value.size(); ++i)
      departures.emplace_back(std::abs(interruption_.departure(&of_.value[i])), i);
    const auto quarter = departures.begin() + std::ssize(departures) / 4;
    std::ranges::nth_element(departures, quarter);
    const double least = std::max(least_, times_usual * quarter->first);
    std::erase_if(departures, [&](const auto& one) {
      return one.first < least || !is_lost(one.second, one.first);
    });
    std::ranges::sort(departures, std::greater());
    std::vector<Stretch> found;
    for (const auto& [size_of_departure, i] : departures) {
      const std::size_t first = i + sides_ + guard_, last = i + size - 1 - sides_ - guard_;
      const auto begin = of_.value.begin() + static_cast<std::ptrdiff_t>(first);
      found.push_back({(of_.time[first - 1] + of_.time[first]) / 2,
                       (of_.time[last] + of_.time[last + 1]) / 2,
                       interruption_.departure(&of_.value[i]),
                       mean({begin, of_.value.begin() + static_cast<std::ptrdiff_t>(last) + 1})});
    }
    return found;
  }

 private:
  static std::vector<double> places(std::size_t size) {
    std::vector<double> found(size);
    std::iota(found.begin(), found.end(), 0.0);
    return found;
  }

  bool is_even(std::size_t first) const {
    double shortest = of_.time[first + 1] - of_.time[first], longest = shortest;
    for (std::size_t i = first + 1; i + 1 < first + interruption_.size(); ++i) {
      shortest = std::min(shortest, of_.time[i + 1] - of_.time[i]);
      longest = std::max(longest, of_.time[i + 1] - of_.time[i]);
    }
    return longest < uneven * shortest;
  }

  bool is_lost(std::size_t first, double departure) const {
    const double* values = &of_.value[first];
    const auto asked = static_cast<double>(interruption_.size() - 2 * guard_);
    const double floor = least_ * least_ * asked, left = interruption_.interrupted(values),
                 own = left + floor, freedom = interruption_.freedom();
    return departure * departure * asked >= times_left * times_left * left &&
           interruption_.whole(values) + floor >=
               std::max(times_whole, 1 + sigma_whole / freedom) * own &&
           interruption_.once(values) + floor >=
               std::max(times_once, 1 + sigma_once / freedom) * own &&
           interruption_.lines(values) + floor >= times_lines * own &&
           !interruption_.overshoots(values) && is_even(first);
  }

  const Grouped& of_;
  std::size_t sides_, guard_;
  double least_;
  Interruption interruption_;
};

bool meets(const Stretch& one, const Stretch& other) {
  return one.begin < other.end && other.begin < one.end;
}

// Shorter stretches first, and of one length those that leave their curve most.
std::vector<Stretch> stretches_of(const TimeSeries& series, double range) {
  Grouped samples{series.time, series.value, 1};
  if (samples.value.size() > most_searched)
    samples = in_groups(samples, samples.value.size() / most_searched + 1);
  std::vector<Stretch> found;
  for (; samples.value.size() > fewest_searched; samples = in_groups(samples, 2))
    for (const std::size_t inside : {3U, 4U, 5U, 6U, 8U, 10U}) {
      if (samples.group > 1 && inside < long_stretch) continue;
      for (const std::size_t sides : {std::max<std::size_t>(4, inside / 2 + 1), inside + 2U})
        for (const Stretch& one : Lengths(samples, inside, sides, range).lost())
          if (std::ranges::none_of(found, [&](const Stretch& other) { return meets(one, other); }))
            found.push_back(one);
    }
  return found;
}

}  // namespace

std::optional<LostStretches> lost_stretches(const TimeSeries& series) {
  if (series.value.size() <= fewest_searched) return std::nullopt;
  const auto [low, high] = std::ranges::minmax(series.value);
  const double range = high - low;
  const std::vector<Stretch> found = stretches_of(series, range);
  if (found.size() < fewest_stretches) return std::nullopt;
  std::vector<double> sizes, values;
  for (const Stretch& one : found) {
    sizes.push_back(std::abs(one.departure) * (one.end - one.begin));
    values.push_back(one.value);
  }
  const double usual = median(sizes);
  double hidden = 0, swing = 0;
  for (const double size : sizes) hidden += std::min(size, 2 * usual);
  hidden /= series.time.back() - series.time.front();
  for (const double one : without_mean(series.value)) swing += std::abs(one);
  swing /= static_cast<double>(series.value.size());
  if (!(hidden >= least_lost_share * swing)) return std::nullopt;
  const Stretch& worst =
      found[static_cast<std::size_t>(std::ranges::max_element(sizes) - sizes.begin())];
  LostStretches told{found.size(), worst.begin, worst.end, hidden};
  const auto [lowest, highest] = std::ranges::minmax(values);
  if (highest - lowest <= 2 * one_value * range) told.value = median(values);
  return told;
}

}  // namespace slosh
