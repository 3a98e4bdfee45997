#include "verification/fits/tone_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace slosh {

using std::numbers::pi;

void require_resolved(TimeWindow window, const std::vector<ToneRequest>& requests) {
  const double length = window.end - window.begin;
  const auto require_apart = [&](double difference, const std::string& which) {
    const double needed = 2 * pi / std::abs(difference);
    if (!(length > needed)) {
      throw ComparisonError(
          fmt::format("the window of {:.4g} s cannot resolve {}; {}", length, which,
                      std::isfinite(needed) ? fmt::format("needed: more than {:.4g} s", needed)
                                            : "no window can"));
    }
  };
  const auto describe = [](const ToneRequest& tone) {
    return fmt::format("{} ({:.4g} Hz)", tone.name, tone.angular_frequency / (2 * pi));
  };
  for (std::size_t i = 0; i < requests.size(); ++i) {
    if (!(requests[i].angular_frequency > 0)) {
      throw ComparisonError(describe(requests[i]) + ": expected a positive frequency");
    }
    require_apart(requests[i].angular_frequency, describe(requests[i]) + " from the mean");
    for (std::size_t j = 0; j < i; ++j) {
      require_apart(requests[i].angular_frequency - requests[j].angular_frequency,
                    describe(requests[j]) + " from " + describe(requests[i]));
    }
  }
}

namespace {

// With fewer than ten samples per period, the cubic interpolation that other metrics use has an
// error above 1 %. The forced and the lowest natural mode make up the wave. A higher natural mode
// is a small part of it, so that its samples need only suffice for its fit: four in a period, twice
// as many as tell it from another frequency.
double longest_interval(const std::vector<ToneRequest>& requests) {
  double lowest_natural = std::numeric_limits<double>::infinity();
  for (const ToneRequest& request : requests)
    if (request.refine) lowest_natural = std::min(lowest_natural, request.angular_frequency);
  double longest = std::numeric_limits<double>::infinity();
  for (const ToneRequest& request : requests) {
    const bool is_higher = request.refine && request.angular_frequency > lowest_natural;
    longest = std::min(longest, 2 * pi / ((is_higher ? 4 : 10) * request.angular_frequency));
  }
  return longest;
}

}  // namespace

void require_sampled(const TimeSeries& cut, const std::vector<ToneRequest>& requests) {
  const double longest = longest_interval(requests);
  for (std::size_t i = 1; i < cut.time.size(); ++i) {
    if (!(cut.time[i] - cut.time[i - 1] <= longest)) {
      throw ComparisonError(
          fmt::format("{}: no sample between {} s and {} s; expected intervals up to {:.3g} s",
                      cut.name, cut.time[i - 1], cut.time[i], longest));
    }
  }
  if (cut.time.size() < 2 * (2 + 4 * requests.size())) {
    throw ComparisonError(fmt::format("{}: {} samples are too few to fit {} tones", cut.name,
                                      cut.time.size(), requests.size()));
  }
}

double wrap_angle(double angle) { return std::remainder(angle, 2 * pi); }

}  // namespace slosh
