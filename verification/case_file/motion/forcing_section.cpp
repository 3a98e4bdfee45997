#include <fmt/format.h>

#include "verification/case_file/case_sections.hpp"
#include "verification/fits/dominant_sine.hpp"

namespace slosh {
namespace {

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

}  // namespace

void read_forcing(const TomlTable& comparison, CaseDefinition& definition) {
  const FrequencyKeys keys = frequency_keys("forcing_");
  const bool has_table = surge_table(definition.motion) || roll_table(definition.motion);
  definition.declared_forcing_frequency = find_angular_frequency(comparison, keys);
  std::vector<std::string> all = keys.all();
  all.push_back("forcing");
  for (const std::string& key : all)
    if (comparison.has(key) && !has_table)
      comparison.refuse(key, "no such key without a motion table: a sine has its own frequency");
  if (!comparison.has("forcing")) return;
  comparison.choice("forcing", "how the frequency of a motion table is known", {"from_spectrum"});
  for (const std::string& key : keys.all())
    if (comparison.has(key)) comparison.refuse(key, "no such key beside forcing");
  find_in_spectrum(comparison, definition);
}

}  // namespace slosh
