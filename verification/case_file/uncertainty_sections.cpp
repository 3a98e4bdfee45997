#include <fmt/format.h>

#include <algorithm>

#include "verification/case/changed_input.hpp"
#include "verification/case/ensemble.hpp"
#include "verification/case/motion.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/key_table.hpp"

namespace slosh {

using namespace key;
using namespace needed;

namespace {

constexpr EnumName<RefinedNumber> refined_number_names[] = {
    {RefinedNumber::particle_spacing, "particle_spacing"},
    {RefinedNumber::smoothing_length_ratio, "smoothing_length_ratio"},
    {RefinedNumber::speed_of_sound, "speed_of_sound"},
    {RefinedNumber::courant_number, "courant_number"},
    {RefinedNumber::mesh, "mesh"}};

// Returns the run without the refined number.
SphRun without(SphRun run, RefinedNumber number) {
  SphNumbers& numbers = run.numbers;
  if (number == RefinedNumber::particle_spacing)
    run.particle_spacing = run.surface_particle_spacing = 0;
  if (number == RefinedNumber::smoothing_length_ratio) numbers.smoothing_length_ratio.reset();
  if (number == RefinedNumber::speed_of_sound) numbers.sound_speed_ratio.reset();
  if (number == RefinedNumber::courant_number) numbers.courant_number.reset();
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

// The runs that solve the flow.
std::vector<std::string> flow_solvers(const CaseDefinition& definition) {
  return names_where(definition.runs,
                     [](const RunDefinition& run) { return solver_kind(run).solves_flow; });
}

void finish_refinement(const TomlTable& refinement, const CaseDefinition& definition,
                       RefinementDefinition& path) {
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
}

void finish_input(const TomlTable& table, const CaseDefinition& definition,
                  InputUncertainty& read) {
  const Input input = read.input = read_name(table, definition);
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
  read.half_width = table.get("half_width", positive(unit));
}

}  // namespace

const FieldTable<RefinementDefinition> refinement_keys{
    {"refinement", "[[refinement]]", "no",
     "Runs that differ in one number only. They give the order and the numerical uncertainty."},
    {field("name", &RefinementDefinition::name, name(), yes),
     field("number", &RefinementDefinition::number, refined_number_names, "what the runs refine",
           yes),
     {{"runs", list("list of run names"), yes,
       "Two or more, each once: SPH runs, with number = \"particle_spacing\" also the runs of one "
       "method of an external program, or with number = \"mesh\" the runs of one program of "
       "OpenFOAM."}}},
    finish_refinement};

const FieldTable<InputUncertainty> input_keys{
    {"input", "[[input]]", "no", "An input that the experiment knows only within an interval."},
    {{{"name", text(), yes,
       "fill_depth, period, amplitude, start_phase, sensor_position, density, kinematic_viscosity "
       "or gravity, each at most once. A still tank has neither period nor amplitude nor "
       "start_phase; a tank that surges and rolls has no amplitude, and a motion by a table no "
       "start_phase."}},
     {{"half_width", number().above(0), yes, "Half the width of the 95 % interval, in `unit`."}},
     {{"unit", text(), yes, "The input's unit."}},
     field("source", &InputUncertainty::source, text(), yes),
     field("coarse_run", &InputUncertainty::coarse_run,
           known("name of an SPH or OpenFOAM run", "an SPH or OpenFOAM run of this case",
                 flow_solvers),
           no,
           "Where no theory of the case holds, this run is repeated at both ends of the interval. "
           "Without it the input's share of such a row's uncertainty is unknown.")},
    finish_input};

}  // namespace slosh
