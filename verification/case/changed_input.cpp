#include "verification/case/changed_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "verification/case/motion.hpp"
#include "verification/case/shape/outline.hpp"

namespace slosh {
namespace {

using std::numbers::pi;

void stretch(SineMotion& sine, double factor) { sine.angular_frequency /= factor; }
void stretch(SumOfSines& sum, double factor) {
  for (SineMotion& sine : sum.sines) stretch(sine, factor);
}
void stretch(TableMotion& table, double factor) {
  for (double& time : table.time) time *= factor;
}

void stretch_time(MotionHistory& motion, double factor) {
  std::visit([&](auto& one) { stretch(one, factor); }, motion);
}

// The change has the motion's own unit, [m] or [rad].
void raise(SineMotion& sine, double change) { sine.amplitude += change; }
// The amplitude of a sum is that of the sines together; they keep their ratios.
void raise(SumOfSines& sum, double change) {
  double amplitude = 0;
  for (const SineMotion& sine : sum.sines) amplitude += sine.amplitude;
  for (SineMotion& sine : sum.sines) sine.amplitude *= 1 + change / amplitude;
}
void raise(TableMotion& table, double change) {
  const auto [low, high] = std::minmax_element(table.value.begin(), table.value.end());
  const double factor = 1 + change / std::max(std::abs(*low), std::abs(*high));
  for (double& value : table.value) value *= factor;
}

void raise_amplitude(MotionHistory& motion, double change) {
  std::visit([&](auto& one) { raise(one, change); }, motion);
}

void stretch_period(CaseDefinition& definition, double change) {
  const double period = 2 * pi / forcing_frequency(definition);
  const double factor = 1 + change / period;
  if (definition.motion.surge) stretch_time(*definition.motion.surge, factor);
  if (definition.motion.roll) stretch_time(definition.motion.roll->angle, factor);
  if (definition.declared_forcing_frequency) *definition.declared_forcing_frequency /= factor;
}

// In a tank that surges and rolls, both motions start elsewhere.
void change_start(CaseDefinition& definition, double radians) {
  const auto change = [radians](MotionHistory& motion) {
    if (auto* sine = std::get_if<SineMotion>(&motion))
      sine->phase += radians;
    else if (auto* sum = std::get_if<SumOfSines>(&motion))
      for (SineMotion& one : sum->sines) one.phase += radians;
    else
      throw std::logic_error("a table's start has no phase");
  };
  if (definition.motion.surge) change(*definition.motion.surge);
  if (definition.motion.roll) change(definition.motion.roll->angle);
}

void move_gauges(CaseDefinition& definition, double change) {
  for (GaugeDefinition& gauge : definition.gauges) gauge.x += change;
  for (PressureGaugeDefinition& gauge : definition.pressure_gauges) {
    gauge.position += change;
    if (gauge.at) gauge.at = moved_along(definition.tank.outline, *gauge.at, change);
  }
  for (ProbeDefinition& probe : definition.probes) probe.x += change;
}

}  // namespace

std::string input_name(Input input) { return name_of(input, input_names); }

std::string input_unit(Input input, const MotionDefinition& motion) {
  switch (input) {
    case Input::period:
      return "s";
    case Input::amplitude:
      return motion.roll ? "deg" : "m";
    case Input::fill_depth:
    case Input::sensor_position:
      return "m";
    case Input::density:
      return "kg/m3";
    case Input::kinematic_viscosity:
      return "m2/s";
    case Input::gravity:
      return "m/s2";
    case Input::start_phase:
      return "deg";
  }
  throw std::logic_error("an input without a unit");
}

CaseDefinition with_input(CaseDefinition definition, Input input, double change) {
  switch (input) {
    case Input::fill_depth:
      definition.liquid.fill_depth += change;
      break;
    case Input::period:
      stretch_period(definition, change);
      break;
    case Input::amplitude:
      if (definition.motion.surge) raise_amplitude(*definition.motion.surge, change);
      if (definition.motion.roll) raise_amplitude(definition.motion.roll->angle, change * pi / 180);
      break;
    case Input::sensor_position:
      move_gauges(definition, change);
      break;
    case Input::density:
      definition.liquid.density += change;
      break;
    case Input::kinematic_viscosity:
      definition.liquid.kinematic_viscosity += change;
      break;
    case Input::gravity:
      definition.gravity += change;
      break;
    case Input::start_phase:
      change_start(definition, change * pi / 180);
      break;
  }
  return definition;
}

CaseDefinition definition_solved_by(const RunDefinition& run, const CaseDefinition& definition) {
  if (run.at_input) return with_input(definition, run.at_input->input, run.at_input->change);
  CaseDefinition solved = definition;
  for (const auto& [input, change] : run.drawn_inputs)
    solved = with_input(std::move(solved), input, change);
  return solved;
}

std::vector<RunDefinition> runs_at_ends(const InputUncertainty& input,
                                        const RunDefinition& repeated) {
  std::vector<RunDefinition> runs;
  for (const auto& [end, change] :
       {std::pair{"lower", -input.half_width}, std::pair{"upper", input.half_width}}) {
    RunDefinition run = repeated;
    run.name = fmt::format("{}_{}_{}", repeated.name, input_name(input.input), end);
    run.ensemble.clear();
    run.varies_inputs = false;
    run.drawn_inputs.clear();
    run.at_input = InputEnd{input.input, change, repeated.name};
    runs.push_back(std::move(run));
  }
  return runs;
}

}  // namespace slosh
