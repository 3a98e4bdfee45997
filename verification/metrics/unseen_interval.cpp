#include "verification/metrics/unseen_interval.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "verification/series/sample_moments.hpp"

namespace slosh {
namespace {

constexpr double least_departure = 0.05, least_gap = 10, least_recorded_gap = 3,
                 resolved_share = 0.01;
// The largest of ten thousand departures of white noise is some 6 of their medians.
constexpr double of_noises_largest = 8;
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

// For each of the times the interval between knots in which it lies, by the place of its end.
std::vector<std::size_t> intervals_of(const std::vector<double>& times,
                                      const std::vector<double>& knots) {
  std::vector<std::size_t> places;
  std::size_t place = 1;
  for (const double time : times) {
    while (place + 1 < knots.size() && knots[place] < time) ++place;
    places.push_back(place);
  }
  return places;
}

// The places of the times that are not inside of intervals of more than so many median ones.
std::vector<std::size_t> outside_long_intervals(const std::vector<double>& times, double medians,
                                                const std::vector<double>& knots) {
  const double longest = medians * median_sample_interval(knots);
  const std::vector<std::size_t> places = intervals_of(times, knots);
  std::vector<std::size_t> outside;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double begin = knots[places[i] - 1], end = knots[places[i]];
    if (end - begin <= longest || times[i] <= begin || times[i] >= end) outside.push_back(i);
  }
  return outside;
}

// The longest gap of the series with the knots; the other is `apart` from its curve at the times.
std::optional<UnseenInterval> longest_gap(const std::vector<double>& knots,
                                          const std::vector<double>& times,
                                          const std::vector<double>& apart) {
  const double median = median_sample_interval(knots);
  double longest = least_gap * median;
  const std::vector<std::size_t> places = intervals_of(times, knots);
  std::optional<UnseenInterval> gap;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double begin = knots[places[i] - 1], end = knots[places[i]];
    if (times[i] < begin + median || times[i] > end - median) continue;
    if (end - begin > longest) {
      longest = end - begin;
      gap = {begin, end, 0};
    }
    if (gap && gap->begin == begin) gap->departure = std::max(gap->departure, std::abs(apart[i]));
  }
  return gap;
}

std::optional<UnseenInterval> unseen_by_reference(const TimeSeries& candidate,
                                                  const CommonSamples& common) {
  if (candidate.time.empty() || common.time.size() < 4) return std::nullopt;
  const TimeSeries seen{candidate.name, candidate.unit, common.time, common.candidate};
  const std::vector<double> apart = minus(interpolate(seen, candidate.time), candidate.value);
  const auto largest = std::max_element(
      apart.begin(), apart.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  const double of_noise = of_noises_largest * median(departures_from_neighbours(candidate));
  if (std::abs(*largest) > of_noise &&
      std::abs(*largest) > least_departure * largest_magnitude(without_mean(candidate.value))) {
    const std::size_t place = intervals_of(
        candidate.time, common.time)[static_cast<std::size_t>(largest - apart.begin())];
    return UnseenInterval{common.time[place - 1], common.time[place], std::abs(*largest)};
  }
  return longest_gap(common.time, candidate.time, apart);
}

}  // namespace

std::optional<UnseenInterval> unseen_interval(const TimeSeries& candidate,
                                              const CommonSamples& common) {
  const auto of_reference = unseen_by_reference(between_ends(candidate, common), common);
  auto of_candidate =
      longest_gap(candidate.time, common.time, minus(common.candidate, common.reference));
  if (!of_candidate || (of_reference && of_reference->departure >= of_candidate->departure))
    return of_reference;
  of_candidate->in_candidate = true;
  return of_candidate;
}

std::optional<TimeWindow> longest_gap(const TimeSeries& whole, TimeWindow window,
                                      double recorded_interval) {
  constexpr double rounding = 1 + 1e-6;
  const std::vector<double>& time = whole.time;
  double longest = rounding * std::min(least_gap * median_sample_interval(time),
                                       least_recorded_gap * recorded_interval);
  std::optional<TimeWindow> gap;
  for (std::size_t i = 1; i < time.size(); ++i) {
    if (time[i] - time[i - 1] <= longest || time[i] <= window.begin || time[i - 1] >= window.end)
      continue;
    longest = time[i] - time[i - 1];
    gap = {time[i - 1], time[i]};
  }
  return gap;
}

double covered_share(const TimeSeries& series, TimeWindow window) {
  const std::vector<double>& time = series.time;
  const double length = window.end - window.begin, median = median_sample_interval(time);
  const double longest = std::max(length / 10, 3 * median);
  double bare = 0;
  for (std::size_t i = 1; i < time.size(); ++i)
    if (time[i] - time[i - 1] > longest)
      bare += std::max(0.0, std::min(time[i], window.end) - std::max(time[i - 1], window.begin));
  for (const double missing : {time.front() - window.begin, window.end - time.back()})
    if (missing > median * (1 + 1e-6)) bare += std::min(missing, length);
  return std::max(0.0, 1 - bare / length);
}

CommonSamples outside_gaps(const TimeSeries& candidate, const CommonSamples& common) {
  CommonSamples outside;
  for (const std::size_t i : outside_long_intervals(common.time, least_gap, candidate.time)) {
    outside.time.push_back(common.time[i]);
    outside.candidate.push_back(common.candidate[i]);
    outside.reference.push_back(common.reference[i]);
  }
  return outside;
}

CommonSamples samples_of_both(const TimeSeries& candidate, const CommonSamples& common) {
  const std::vector<double> times = between_ends(candidate, common).time;
  if (times == common.time || !resolves_itself(common)) return common;
  std::vector<double> seen;
  for (const std::size_t i : outside_long_intervals(times, longest_resolved, common.time))
    seen.push_back(times[i]);
  CommonSamples both;
  std::set_union(common.time.begin(), common.time.end(), seen.begin(), seen.end(),
                 std::back_inserter(both.time));
  const auto at_both = [&](const std::vector<double>& values) {
    return interpolate({"", "", common.time, values}, both.time);
  };
  both.reference = at_both(common.reference);
  both.candidate = interpolate(candidate, both.time);
  return both;
}

}  // namespace slosh
