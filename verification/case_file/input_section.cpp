#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "verification/case/inputs.hpp"
#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/key_table.hpp"

namespace slosh {
namespace {

struct InputEntry {
  const char* name;
  Input input;
  const char* unit;  // of an amplitude that of a surge
};

constexpr std::array<InputEntry, 7> entries{{
    {"fill_depth", Input::fill_depth, "m"},
    {"period", Input::period, "s"},
    {"amplitude", Input::amplitude, "m"},
    {"sensor_position", Input::sensor_position, "m"},
    {"density", Input::density, "kg/m3"},
    {"kinematic_viscosity", Input::kinematic_viscosity, "m2/s"},
    {"gravity", Input::gravity, "m/s2"},
}};

const InputEntry& entry_of(Input input) {
  return *std::find_if(entries.begin(), entries.end(),
                       [input](const InputEntry& entry) { return entry.input == input; });
}

const InputEntry& read_name(const TomlTable& table, const CaseDefinition& definition) {
  std::vector<std::string> names;
  for (const InputEntry& entry : entries) {
    const bool of_motion = entry.input == Input::period || entry.input == Input::amplitude;
    if (!of_motion || !definition.motion.still()) names.push_back(entry.name);
  }
  const std::string name = table.choice("name", "an input that this case has", names);
  return *std::find_if(entries.begin(), entries.end(),
                       [&](const InputEntry& entry) { return entry.name == name; });
}

std::string read_coarse_run(const TomlTable& table, const CaseDefinition& definition) {
  std::vector<std::string> names;
  for (const RunDefinition& run : definition.runs)
    if (std::holds_alternative<SphRun>(run.solver) ||
        std::holds_alternative<InterFoamRun>(run.solver))
      names.push_back(run.name);
  return table.choice("coarse_run", "an SPH or interFoam run of this case", names);
}

}  // namespace

std::string input_name(Input input) { return entry_of(input).name; }

std::string input_unit(Input input, const MotionDefinition& motion) {
  return input == Input::amplitude && motion.roll ? "deg" : entry_of(input).unit;
}

InputUncertainty read_input(const TomlTable& table, const CaseDefinition& definition) {
  table.allow_only(keys_of("input"));
  const InputEntry& entry = read_name(table, definition);
  if (entry.input == Input::amplitude && definition.motion.surge && definition.motion.roll)
    table.refuse("name", "an input of one motion: this tank surges and rolls");
  const std::string unit = table.choice("unit", fmt::format("the unit of {}", entry.name),
                                        {input_unit(entry.input, definition.motion)});
  for (const InputUncertainty& other : definition.inputs)
    if (other.input == entry.input) table.refuse("name", "each input once");
  return {entry.input, table.get("half_width", positive(unit)), table.get("source", any_text()),
          table.has("coarse_run") ? read_coarse_run(table, definition) : ""};
}

}  // namespace slosh
