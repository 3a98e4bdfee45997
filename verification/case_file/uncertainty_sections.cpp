#include <fmt/format.h>

#include <algorithm>

#include "verification/case/changed_input.hpp"
#include "verification/case/ensemble.hpp"
#include "verification/case/motion.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/key_table.hpp"

namespace slosh {
namespace {

constexpr EnumName<RefinedNumber> refined_number_names[] = {
    {RefinedNumber::particle_spacing, "particle_spacing"},
    {RefinedNumber::smoothing_length_ratio, "smoothing_length_ratio"},
    {RefinedNumber::speed_of_sound, "speed_of_sound"},
    {RefinedNumber::courant_number, "courant_number"},
    {RefinedNumber::mesh, "mesh"}};

// Returns the run without the refined number.
SphRun without(SphRun run, RefinedNumber number) {
  switch (number) {
    case RefinedNumber::particle_spacing:
      run.particle_spacing = run.surface_particle_spacing = 0;
      break;
    case RefinedNumber::smoothing_length_ratio:
      run.numbers.smoothing_length_ratio.reset();
      break;
    case RefinedNumber::speed_of_sound:
      run.numbers.sound_speed_ratio.reset();
      break;
    case RefinedNumber::courant_number:
      run.numbers.courant_number.reset();
      break;
    case RefinedNumber::mesh:
      break;
  }
  run.energy_budget = false;  // it only records
  return run;
}

bool are_alike(const RunDefinition& one, const RunDefinition& other, RefinedNumber number) {
  const auto* a = std::get_if<SphRun>(&one.solver);
  const auto* b = std::get_if<SphRun>(&other.solver);
  if (a && b) return without(*a, number) == without(*b, number);
  return !a && !b && work_family(one) == work_family(other);
}

bool has_number(const RunDefinition& run, RefinedNumber number) {
  if (number == RefinedNumber::mesh) return std::holds_alternative<InterFoamRun>(run.solver);
  if (number == RefinedNumber::particle_spacing) return particle_spacing(run).has_value();
  return std::holds_alternative<SphRun>(run.solver);
}

const char* runs_with(RefinedNumber number) {
  if (number == RefinedNumber::mesh) return "OpenFOAM runs";
  if (number == RefinedNumber::particle_spacing) return "runs with particle_spacing_m";
  return "SPH runs";
}

bool is_table(const MotionHistory& motion) { return std::holds_alternative<TableMotion>(motion); }

bool has_input(const MotionDefinition& motion, Input input) {
  if (input == Input::start_phase)
    return !motion.still() && !(motion.surge && is_table(*motion.surge)) &&
           !(motion.roll && is_table(motion.roll->angle));
  const bool of_motion = input == Input::period || input == Input::amplitude;
  return !of_motion || !motion.still();
}

Input read_name(const TomlTable& table, const CaseDefinition& definition) {
  const auto names = names_where(input_names, [&](const EnumName<Input>& input) {
    return has_input(definition.motion, input.value);
  });
  return value_of(table.choice("name", "an input that this case has", names), input_names);
}

std::string read_coarse_run(const TomlTable& table, const CaseDefinition& definition) {
  const auto solves_flow = [](const RunDefinition& run) { return solver_kind(run).solves_flow; };
  return table.choice("coarse_run", "an SPH or OpenFOAM run of this case",
                      names_where(definition.runs, solves_flow));
}

}  // namespace

RefinementDefinition read_refinement(const TomlTable& refinement,
                                     const CaseDefinition& definition) {
  refinement.allow_only(keys_of("refinement"));
  RefinementDefinition path;
  path.name = refinement.get("name", file_safe_name());
  path.number = refinement.choice("number", "what the runs refine", refined_number_names);
  const auto known = names_where(definition.runs, [&](const RunDefinition& run) {
    return !is_later_member(run) && has_number(run, path.number);
  });
  for (const PlacedText& run : refinement.texts("runs", any_text())) {
    if (std::find(known.begin(), known.end(), run.text) == known.end())
      refinement.refuse(
          "runs", fmt::format("{} of this case; {} is not one", runs_with(path.number), run.text));
    const auto* sph = std::get_if<SphRun>(&run_named(definition, run.text).solver);
    if (sph && sph->speed_from_coarse_run)
      refinement.refuse("runs",
                        fmt::format("runs with expected_speed = \"estimate\": the speed of sound "
                                    "of {}, from a coarse run, would differ beside the refined "
                                    "number",
                                    run.text));
    if (std::find(path.runs.begin(), path.runs.end(), run.text) != path.runs.end())
      refinement.refuse("runs", fmt::format("each run once; {} is there twice", run.text));
    if (!path.runs.empty() && !are_alike(run_named(definition, path.runs.front()),
                                         run_named(definition, run.text), path.number))
      refinement.refuse(
          "runs",
          fmt::format("runs that differ in the refined number only; {} and {} differ in others",
                      path.runs.front(), run.text));
    path.runs.push_back(run.text);
  }
  if (path.runs.size() < 2) refinement.refuse("runs", "two runs or more");
  return path;
}

InputUncertainty read_input(const TomlTable& table, const CaseDefinition& definition) {
  table.allow_only(keys_of("input"));
  const Input input = read_name(table, definition);
  if (input == Input::amplitude && definition.motion.surge && definition.motion.roll)
    table.refuse("name", "an input of one motion: this tank surges and rolls");
  if (input == Input::period && !(forcing_frequency(definition) > 0))
    table.refuse("name",
                 "an input that this case has: its motion has no single period (a table names one "
                 "by forcing_period_s in [comparison])");
  const std::string unit = table.choice("unit", fmt::format("the unit of {}", input_name(input)),
                                        {input_unit(input, definition.motion)});
  for (const InputUncertainty& other : definition.inputs)
    if (other.input == input) table.refuse("name", "each input once");
  return {input, table.get("half_width", positive(unit)), table.get("source", any_text()),
          table.has("coarse_run") ? read_coarse_run(table, definition) : ""};
}

}  // namespace slosh
