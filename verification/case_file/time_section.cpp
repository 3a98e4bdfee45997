#include <fmt/format.h>

#include <cmath>

#include "verification/case_file/case_sections.hpp"
#include "verification/fits/dominant_sine.hpp"

namespace slosh {

using namespace key;
using namespace needed;

namespace {

// More would take long before anything runs, and exhaust the memory without a word.
constexpr double most_samples = 2e6;
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

Rule<double> a_sample_interval(const CaseDefinition& definition) {
  const double most = definition.duration;
  return {fmt::format("a number > 0 and <= the duration ({}), in s, and >= {:.3g}, for at most two "
                      "million samples",
                      most, most / most_samples),
          [most](double value) { return value >= most / most_samples && value <= most; }};
}

Rule<double> natural_modes_to_fit(const CaseDefinition& definition) {
  if (definition.gravity == 0)
    return {"0 without gravity: there is no natural mode", [](double modes) { return modes == 0; },
            0};
  if (definition.liquid.column_width)
    return {"0 for a dam about to break, which linear theory does not describe",
            [](double modes) { return modes == 0; }, 0};
  if (definition.motion.still() && definition.initial_wave)
    return {"0 or 1: a still tank has only the mode of its initial wave",
            [](double modes) { return modes == 0 || modes == 1; }, 0};
  return {fmt::format("an integer from 0 to {}", most_natural_modes),
          [](double modes) { return modes >= 0 && modes <= most_natural_modes; }, 0};
}

// Fewer show no motion; more make a page that takes long to load.
constexpr long fewest_times = 3, most_times = 60;

void list_times(const TomlTable& animation, const CaseDefinition& definition, Animation& read) {
  const auto& [begin, end, interval, none] = read;
  const long count = std::lround(std::floor((end - begin) / interval + 1e-9)) + 1;
  if (!(count >= fewest_times && count <= most_times))
    animation.refuse("interval_s",
                     fmt::format("a number that gives {} to {} times from begin_s to end_s, in s",
                                 fewest_times, most_times));
  const double first = std::round(begin / definition.sample_interval),
               stride = std::round(interval / definition.sample_interval);
  for (long i = 0; i < count; ++i)
    read.times.push_back((first + static_cast<double>(i) * stride) * definition.sample_interval);
}

const TableMotion* surge_table(const MotionDefinition& motion) {
  return motion.surge ? std::get_if<TableMotion>(&*motion.surge) : nullptr;
}

const TableMotion* roll_table(const MotionDefinition& motion) {
  return motion.roll ? std::get_if<TableMotion>(&motion.roll->angle) : nullptr;
}

void find_in_spectrum(const TomlTable& comparison, CaseDefinition& definition) {
  const TableMotion *surge = surge_table(definition.motion), *roll = roll_table(definition.motion);
  if (surge && roll)
    comparison.refuse("forcing",
                      "forcing_frequency_Hz instead, as two tables have no spectrum in common");
  const TableMotion& table = surge ? *surge : *roll;
  try {
    const DominantSine sine = dominant_sine(
        {table.file.filename().string(), surge ? "m" : "rad", table.time, table.value},
        {definition.window_begin, definition.window_end});
    definition.declared_forcing_frequency = sine.angular_frequency.value;
    definition.found_forcing = {sine.angular_frequency.half_width, sine.rest};
  } catch (const ComparisonError& error) {
    comparison.refuse(
        "forcing",
        fmt::format("a motion table that is nearly one sine from {:g} to {:g} s, the window of the "
                    "comparison; {}. Write forcing_frequency_Hz or forcing_period_s instead to "
                    "name the frequency that is meant",
                    definition.window_begin, definition.window_end, error.what()));
  }
}

void read_forcing(const TomlTable& comparison, CaseDefinition& definition) {
  const bool has_table = surge_table(definition.motion) || roll_table(definition.motion);
  definition.declared_forcing_frequency = find_angular_frequency(comparison, "forcing_");
  const std::vector<std::string> keys = names_of_frequency("forcing_");
  for (const char* key : {keys[0].c_str(), keys[1].c_str(), keys[2].c_str(), "forcing"})
    if (comparison.has(key) && !has_table)
      comparison.refuse(key, "no such key without a motion table: a sine has its own frequency");
  if (!comparison.has("forcing")) return;
  comparison.choice("forcing", "how the frequency of a motion table is known", {"from_spectrum"});
  for (const std::string& key : keys)
    if (comparison.has(key)) comparison.refuse(key, "no such key beside forcing");
  find_in_spectrum(comparison, definition);
}

void end_window(const TomlTable& comparison, const CaseDefinition&, CaseDefinition& read) {
  if (!comparison.has("window_end_s")) read.window_end = read.duration;
  if (!(read.window_begin < read.duration))
    comparison.refuse("window_begin_s",
                      fmt::format("a number below the duration ({}), in s", read.duration));
  read_forcing(comparison, read);
}

}  // namespace

const FieldTable<CaseDefinition> time_keys{
    {"time", "[time]", "yes", ""},
    {field("start", &CaseDefinition::start, start_names,
           "the frame in which the liquid is first at rest (earth: the liquid stands still and a "
           "tank that moves off at once strikes it; tank: the liquid moves off with the tank)",
           yes,
           "The frame in which the liquid is at rest at the start. Earth: it stands still, and a "
           "tank that moves off at once strikes it. Tank: it moves off with the tank."),
     field("duration_s", &CaseDefinition::duration, number("s").above(0), yes),
     field("sample_interval_s", &CaseDefinition::sample_interval,
           number("s").above(0).at_most(case_duration).by(a_sample_interval), yes,
           "The interval of the recorded samples. SPH lands on each, so a short one shortens its "
           "time step. There are ten million at most."),
     field("snapshot_times_s", &CaseDefinition::snapshot_times,
           increasing_list_of(number("s").above(0).at_most(case_duration).by(sampled)), no,
           "The times at which fields are kept: multiples of sample_interval_s.")}};

const FieldTable<Animation> animation_keys{
    {"animation", "[animation]", "no",
     "SPH and OpenFOAM keep their fields at 3 to 60 moments, and the report plays the finest run "
     "of each scheme and of each program of OpenFOAM side by side."},
    {field("begin_s", &Animation::begin, number("s").above(0).at_most(case_duration).by(sampled),
           yes, "A multiple of sample_interval_s, as are the others."),
     field("end_s", &Animation::end, number("s").above(0).at_most(case_duration).by(sampled), yes),
     field("interval_s", &Animation::interval,
           number("s").above(0).at_most(case_duration).by(sampled), yes)},
    list_times};

const FieldTable<CaseDefinition> comparison_keys{
    {"comparison", "[comparison]", "yes", "The window in which histories are compared."},
    {field("window_begin_s", &CaseDefinition::window_begin, number("s").at_least(0), yes),
     field("window_end_s", &CaseDefinition::window_end,
           number("s").above(Bound("window_begin_s")).at_most(case_duration), no,
           "Default: duration_s."),
     field("natural_modes", &CaseDefinition::natural_modes,
           integer().from(0, most_natural_modes).by(natural_modes_to_fit), yes,
           "The number of natural modes that are fitted beside the forced one: 0 for a dam or "
           "without gravity, at most 1 for a still tank's initial wave."),
     {{"forcing", one_of({"from_spectrum"}), no,
       "Finds the forcing frequency of a motion table from its spectrum in this window, and "
       "refuses a table that is not nearly one sine there."}},
     {{"forcing_angular_frequency_rad_s", number("rad/s").above(0), no,
       "The forcing frequency of a motion table that is nearly a sine; refused where no motion "
       "is a table."}},
     {{"forcing_frequency_Hz", number("Hz").above(0), no, "The same in another unit."}},
     {{"forcing_period_s", number("s").above(0), no, "The same as a period."}}},
    end_window};

}  // namespace slosh
