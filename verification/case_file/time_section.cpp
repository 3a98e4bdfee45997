#include <fmt/format.h>

#include <cmath>

#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/key_table.hpp"

namespace slosh {
namespace {

// Of numbers written with a few decimals, whose quotient rounding spoils in the last digits.
bool is_multiple(double value, double interval) {
  const double quotient = value / interval;
  return std::abs(quotient - std::round(quotient)) <= 1e-9 * quotient;
}

bool follows_a_table(const MotionDefinition& motion) {
  return (motion.surge && std::holds_alternative<TableMotion>(*motion.surge)) ||
         (motion.roll && std::holds_alternative<TableMotion>(motion.roll->angle));
}

Rule<int> natural_modes_to_fit(const CaseDefinition& definition) {
  if (definition.gravity == 0)
    return {"0 without gravity: no liquid sways by itself", [](int modes) { return modes == 0; },
            0};
  if (definition.liquid.column_width)
    return {"0 of a dam about to break, which linear theory does not know",
            [](int modes) { return modes == 0; }, 0};
  if (definition.motion.still() && definition.initial_wave)
    return {"0 or 1: a tank that stands has the mode of its initial wave alone",
            [](int modes) { return modes == 0 || modes == 1; }, 0};
  return at_least(0);
}

}  // namespace

void read_time(const TomlTable& time, CaseDefinition& definition) {
  time.allow_only(keys_of("time"));
  definition.start = time.choice("start", "the frame in which the liquid is first at rest",
                                 {"earth", "tank"}) == "earth"
                         ? Start::earth
                         : Start::tank;
  definition.duration = time.get("duration_s", positive("s"));
  definition.sample_interval = time.get<double>(
      "sample_interval_s",
      {fmt::format("a number > 0 and <= the duration ({}), in s", definition.duration),
       [most = definition.duration](double value) { return value > 0 && value <= most; }});
  definition.snapshot_times = time.increasing_numbers(
      "snapshot_times_s",
      {fmt::format("a number > 0 and <= the duration ({}), a multiple of sample_interval_s ({}), "
                   "in s",
                   definition.duration, definition.sample_interval),
       [&](double value) {
         return value > 0 && value <= definition.duration &&
                is_multiple(value, definition.sample_interval);
       }});
}

void read_comparison(const TomlTable& comparison, CaseDefinition& definition) {
  comparison.allow_only(keys_of("comparison"));
  definition.window_begin = comparison.get("window_begin_s", not_negative("s"));
  definition.window_end = comparison.get(
      "window_end_s", end_after("window_begin_s", definition.window_begin, definition.duration));
  definition.natural_modes = comparison.get("natural_modes", natural_modes_to_fit(definition));
  definition.declared_forcing_frequency =
      comparison.find("forcing_angular_frequency_rad_s", positive("rad/s"));
  if (definition.declared_forcing_frequency && !follows_a_table(definition.motion))
    comparison.refuse("forcing_angular_frequency_rad_s",
                      "no such key where no motion is a table: a sine has its own");
}

}  // namespace slosh
