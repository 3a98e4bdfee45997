#include "verification/metrics/unseen_interval.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "verification/series/sample_moments.hpp"

namespace slosh {
namespace {

constexpr double least_departure = 0.05, least_gap = 10, resolved_share = 0.01;
// [median intervals] Through every second sample a reference resolves itself.
constexpr double longest_resolved = 2;

double largest_magnitude(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

// The candidate's samples inside the span of the common ones.
TimeSeries between_ends(const TimeSeries& candidate, const CommonSamples& common) {
  const auto first =
      std::lower_bound(candidate.time.begin(), candidate.time.end(), common.time.front());
  const auto last = std::upper_bound(first, candidate.time.end(), common.time.back());
  const auto value = [&](auto at) {
    return candidate.value.begin() + (at - candidate.time.begin());
  };
  return {candidate.name, candidate.unit, {first, last}, {value(first), value(last)}};
}

bool resolves_itself(const CommonSamples& common) {
  TimeSeries kept, left_out;
  for (std::size_t i = 0; i < common.time.size(); ++i) {
    TimeSeries& of = i % 2 == 0 ? kept : left_out;
    of.time.push_back(common.time[i]);
    of.value.push_back(common.reference[i]);
  }
  if (left_out.time.back() > kept.time.back()) {
    left_out.time.pop_back();
    left_out.value.pop_back();
  }
  if (kept.time.size() < 4) return false;
  return largest_magnitude(minus(interpolate(kept, left_out.time), left_out.value)) <=
         resolved_share * largest_magnitude(without_mean(common.reference));
}

// The reference's interval, by the place of its end, for each sample inside.
std::vector<std::size_t> intervals_of(const std::vector<double>& times,
                                      const CommonSamples& common) {
  std::vector<std::size_t> places;
  std::size_t place = 1;
  for (const double time : times) {
    while (place + 1 < common.time.size() && common.time[place] < time) ++place;
    places.push_back(place);
  }
  return places;
}

std::vector<double> lengths_of_intervals(const CommonSamples& common) {
  std::vector<double> lengths;
  for (std::size_t i = 1; i < common.time.size(); ++i)
    lengths.push_back(common.time[i] - common.time[i - 1]);
  return lengths;
}

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::optional<UnseenInterval> longest_gap(const std::vector<std::size_t>& places,
                                          const std::vector<double>& apart,
                                          const CommonSamples& common) {
  const std::vector<double> lengths = lengths_of_intervals(common);
  const auto longest = std::max_element(lengths.begin(), lengths.end());
  const auto place = static_cast<std::size_t>(longest - lengths.begin()) + 1;
  // The candidate's sample at the interval's end counts too.
  const auto inside = std::equal_range(places.begin(), places.end(), place);
  if (!(*longest > least_gap * median_of(lengths)) || inside.second - inside.first < 3)
    return std::nullopt;
  double largest = 0;
  for (auto at = inside.first; at != inside.second; ++at)
    largest = std::max(largest, std::abs(apart[static_cast<std::size_t>(at - places.begin())]));
  return UnseenInterval{common.time[place - 1], common.time[place], largest};
}

}  // namespace

std::optional<UnseenInterval> unseen_interval(const TimeSeries& whole_candidate,
                                              const CommonSamples& common) {
  const TimeSeries candidate = between_ends(whole_candidate, common);
  if (candidate.time.empty() || common.time.size() < 4) return std::nullopt;
  const TimeSeries seen{candidate.name, candidate.unit, common.time, common.candidate};
  const std::vector<double> apart = minus(interpolate(seen, candidate.time), candidate.value);
  const std::vector<std::size_t> places = intervals_of(candidate.time, common);
  const auto largest = std::max_element(
      apart.begin(), apart.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  if (std::abs(*largest) > least_departure * largest_magnitude(without_mean(candidate.value))) {
    const std::size_t place = places[static_cast<std::size_t>(largest - apart.begin())];
    return UnseenInterval{common.time[place - 1], common.time[place], std::abs(*largest)};
  }
  return longest_gap(places, apart, common);
}

CommonSamples samples_of_both(const TimeSeries& candidate, const CommonSamples& common) {
  std::vector<double> times = between_ends(candidate, common).time;
  if (times == common.time || !resolves_itself(common)) return common;
  const std::vector<double> lengths = lengths_of_intervals(common);
  const double longest = longest_resolved * median_of(lengths);
  const std::vector<std::size_t> places = intervals_of(times, common);
  std::size_t at = 0;
  std::erase_if(times, [&](double) { return lengths[places[at++] - 1] > longest; });
  CommonSamples both;
  std::set_union(common.time.begin(), common.time.end(), times.begin(), times.end(),
                 std::back_inserter(both.time));
  const auto at_both = [&](const std::vector<double>& values) {
    return interpolate({"", "", common.time, values}, both.time);
  };
  both.reference = at_both(common.reference);
  both.candidate = interpolate(candidate, both.time);
  return both;
}

}  // namespace slosh
