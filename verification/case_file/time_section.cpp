#include <fmt/format.h>

#include <cmath>

#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/key_table.hpp"

namespace slosh {
namespace {

// More would not fit the memory, which is then exhausted without a word.
constexpr double most_samples = 1e7;
constexpr int most_natural_modes = 100;

// The tolerance is for the rounding of numbers that are written with a few decimals.
bool is_multiple(double value, double interval) {
  const double quotient = value / interval;
  return std::abs(quotient - std::round(quotient)) <= 1e-9 * quotient;
}

// A time at which the runs record a sample.
Rule<double> sampled(const CaseDefinition& definition) {
  return {
      fmt::format("a number > 0 and <= the duration ({}), a multiple of sample_interval_s ({}), "
                  "in s",
                  definition.duration, definition.sample_interval),
      [&definition](double value) {
        return value > 0 && value <= definition.duration &&
               is_multiple(value, definition.sample_interval);
      }};
}

Rule<int> natural_modes_to_fit(const CaseDefinition& definition) {
  if (definition.gravity == 0)
    return {"0 without gravity: there is no natural mode", [](int modes) { return modes == 0; }, 0};
  if (definition.liquid.column_width)
    return {"0 for a dam about to break, which linear theory does not describe",
            [](int modes) { return modes == 0; }, 0};
  if (definition.motion.still() && definition.initial_wave)
    return {"0 or 1: a still tank has only the mode of its initial wave",
            [](int modes) { return modes == 0 || modes == 1; }, 0};
  return integer_between(0, most_natural_modes);
}

// Fewer show no motion; more make a page that takes long to load.
constexpr long fewest_times = 3, most_times = 60;

}  // namespace

double read_time_offset(const TomlTable& table) {
  return table.find("time_offset_s", any_number("s")).value_or(0);
}

void read_time(const TomlTable& time, CaseDefinition& definition) {
  time.allow_only(keys_of("time"));
  definition.start =
      time.choice("start",
                  "the frame in which the liquid is first at rest (earth: the liquid stands still "
                  "and a tank that moves off at once strikes it; tank: the liquid moves off with "
                  "the tank)",
                  start_names);
  definition.duration = time.get("duration_s", positive("s"));
  definition.sample_interval = time.get<double>(
      "sample_interval_s",
      {fmt::format(
           "a number > 0 and <= the duration ({}), in s, and >= {:.3g}, for at most ten million "
           "samples",
           definition.duration, definition.duration / most_samples),
       [most = definition.duration](double value) {
         return value >= most / most_samples && value <= most;
       }});
  definition.snapshot_times = time.increasing_numbers("snapshot_times_s", sampled(definition));
}

void read_comparison(const TomlTable& comparison, CaseDefinition& definition) {
  comparison.allow_only(keys_of("comparison"));
  definition.window_begin = comparison.get("window_begin_s", not_negative("s"));
  const auto before_end = end_after("window_begin_s", definition.window_begin, definition.duration);
  definition.window_end =
      definition.window_begin < definition.duration
          ? comparison.find("window_end_s", before_end).value_or(definition.duration)
          : comparison.get("window_end_s", before_end);
  definition.natural_modes = comparison.get("natural_modes", natural_modes_to_fit(definition));
  read_forcing(comparison, definition);
}

std::vector<double> read_animation(const TomlTable& animation, const CaseDefinition& definition) {
  animation.allow_only(keys_of("animation"));
  const Rule<double> rule = sampled(definition);
  const double begin = animation.get("begin_s", rule), end = animation.get("end_s", rule),
               interval = animation.get("interval_s", rule);
  const long count = std::lround(std::floor((end - begin) / interval + 1e-9)) + 1;
  if (!(count >= fewest_times && count <= most_times))
    animation.refuse("interval_s",
                     fmt::format("a number that gives {} to {} times from begin_s to end_s, in s",
                                 fewest_times, most_times));
  std::vector<double> times;
  const double first = std::round(begin / definition.sample_interval),
               stride = std::round(interval / definition.sample_interval);
  for (long i = 0; i < count; ++i)
    times.push_back((first + static_cast<double>(i) * stride) * definition.sample_interval);
  return times;
}

}  // namespace slosh
