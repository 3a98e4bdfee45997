#include "verification/metrics/series_mutation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <stdexcept>
#include <utility>

#include "verification/series/sample_moments.hpp"
#include "verification/series/time_series.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

constexpr std::uint64_t noise_seed = 20090401;  // arbitrary; fixed, so that reports repeat
constexpr double thousand = 1000;

TimeSeries scaled(TimeSeries series, double factor) {
  for (double& value : series.value) value *= factor;
  return series;
}

// The series' values at other times, given at its own sample times.
TimeSeries moved_in_time(const TimeSeries& series, const std::function<double(double)>& taken_at) {
  std::vector<double> times(series.time.size());
  std::transform(series.time.begin(), series.time.end(), times.begin(), [&](double t) {
    return std::clamp(taken_at(t), series.time.front(), series.time.back());
  });
  TimeSeries moved = series;
  moved.value = interpolate(series, times);
  return moved;
}

TimeSeries delayed(const TimeSeries& series, double lag) {
  return moved_in_time(series, [lag](double t) { return t - lag; });
}

TimeSeries stretched(const TimeSeries& series, double speed) {
  const double begin = series.time.front();
  return moved_in_time(series, [=](double t) { return begin + speed * (t - begin); });
}

TimeSeries shifted(TimeSeries series, double offset) {
  for (double& value : series.value) value += offset;
  return series;
}

// How much of the window has passed at time t: 0 before it, 1 after it.
double share_of_window(double t, TimeWindow window) {
  return std::clamp((t - window.begin) / (window.end - window.begin), 0.0, 1.0);
}

TimeSeries drifting(TimeSeries series, TimeWindow window, double at_end) {
  for (std::size_t i = 0; i < series.value.size(); ++i)
    series.value[i] += at_end * share_of_window(series.time[i], window);
  return series;
}

TimeSeries chirped(const TimeSeries& series, TimeWindow window, double lead) {
  return moved_in_time(series, [=](double t) {
    const double u = share_of_window(t, window);
    return t + lead * u * u;
  });
}

// Adds the mode's part of the fit times gain(time since the window's begin, decay rate).
template <class Gain>
TimeSeries with_mode_changed(TimeSeries series, const Mutation& mutation,
                             const MutationFrame& frame, const Gain& gain) {
  const auto tone = std::find_if(frame.tones.begin(), frame.tones.end(),
                                 [&](const Tone& one) { return one.name == mutation.mode; });
  if (tone == frame.tones.end())
    throw ComparisonError("the mode " + mutation.mode + " is not fitted");
  for (std::size_t i = 0; i < series.value.size(); ++i) {
    const double t = series.time[i], since = std::max(0.0, t - frame.window.begin);
    series.value[i] += gain(since, tone->decay_rate.value) * tone->amplitude.value *
                       std::exp(-tone->decay_rate.value * since) *
                       std::cos(tone->angular_frequency.value * t + tone->phase.value);
  }
  return series;
}

TimeSeries with_white_noise(TimeSeries series, double deviation) {
  std::mt19937_64 generator(noise_seed);
  std::normal_distribution<double> normal;
  for (double& value : series.value) value += deviation * normal(generator);
  return series;
}

TimeSeries ending_at(TimeSeries series, double last_time) {
  const auto kept = static_cast<std::size_t>(
      std::upper_bound(series.time.begin(), series.time.end(), last_time) - series.time.begin());
  series.time.resize(kept);
  series.value.resize(kept);
  return series;
}

TimeSeries poisoned_at(TimeSeries series, double time) {
  const auto nearest = std::min_element(
      series.time.begin(), series.time.end(),
      [time](double a, double b) { return std::abs(a - time) < std::abs(b - time); });
  series.value[static_cast<std::size_t>(nearest - series.time.begin())] = not_a_number;
  return series;
}

}  // namespace

TimeSeries mutated(const TimeSeries& series, const Mutation& mutation, const MutationFrame& frame) {
  const TimeWindow window = frame.window;
  const double period = frame.period, datum = frame.datum;
  const TimeSeries judged = cut_to_window(series, window);
  const double s = mutation.strength;
  TimeSeries result = series;
  switch (mutation.kind) {
    case MutationKind::louder:
      return scaled(series, 1 + s);
    case MutationKind::quieter:
      return scaled(series, 1 - s);
    case MutationKind::late:
    case MutationKind::slipped:
      return delayed(series, s * period);
    case MutationKind::early:
      return delayed(series, -s * period);
    case MutationKind::faster:
      return stretched(series, 1 + s);
    case MutationKind::slower:
      return stretched(series, 1 - s);
    case MutationKind::raised:
      return shifted(series, s * datum);
    case MutationKind::lowered:
      return shifted(series, -s * datum);
    case MutationKind::drifting:
      return drifting(series, window, s * rms(without_mean(judged.value)));
    case MutationKind::chirped:
      return chirped(series, window, s * period);
    case MutationKind::mode_gained:
      return with_mode_changed(series, mutation, frame, [s](double, double) { return s; });
    case MutationKind::mode_damped:
      return with_mode_changed(series, mutation, frame, [s](double since, double decay_rate) {
        return std::expm1(-s * decay_rate * since);
      });
    case MutationKind::noisy:
      return with_white_noise(series, s * rms(without_mean(judged.value)));
    case MutationKind::truncated:
      return ending_at(series, window.end - s * (window.end - window.begin));
    case MutationKind::not_a_number:
      return poisoned_at(series, std::midpoint(window.begin, window.end));
    case MutationKind::swapped_columns:
      std::swap(result.time, result.value);
      return result;
    case MutationKind::thousandfold:
      return scaled(series, thousand);
    case MutationKind::other_unit:
      result.unit = "m" + series.unit;
      return result;
    case MutationKind::sign_flipped:
      return scaled(series, -1);
  }
  throw std::logic_error("a mutation without an effect");
}

std::string mutation_name(MutationKind kind) {
  switch (kind) {
    case MutationKind::louder:
      return "louder";
    case MutationKind::quieter:
      return "quieter";
    case MutationKind::late:
      return "late";
    case MutationKind::early:
      return "early";
    case MutationKind::faster:
      return "faster";
    case MutationKind::slower:
      return "slower";
    case MutationKind::raised:
      return "raised";
    case MutationKind::lowered:
      return "lowered";
    case MutationKind::drifting:
      return "drifting";
    case MutationKind::chirped:
      return "chirped";
    case MutationKind::mode_gained:
      return "mode gained";
    case MutationKind::mode_damped:
      return "mode damped";
    case MutationKind::noisy:
      return "noisy";
    case MutationKind::slipped:
      return "slipped";
    case MutationKind::truncated:
      return "truncated";
    case MutationKind::not_a_number:
      return "not a number";
    case MutationKind::swapped_columns:
      return "swapped columns";
    case MutationKind::thousandfold:
      return "thousandfold";
    case MutationKind::other_unit:
      return "other unit";
    case MutationKind::sign_flipped:
      return "sign flipped";
  }
  throw std::logic_error("a mutation without a name");
}

bool changes_values(MutationKind kind) {
  switch (kind) {
    case MutationKind::truncated:
    case MutationKind::not_a_number:
    case MutationKind::swapped_columns:
    case MutationKind::other_unit:
      return false;
    default:
      return true;
  }
}

}  // namespace slosh
