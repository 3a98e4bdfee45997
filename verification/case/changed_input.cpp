#include "verification/case/changed_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "verification/case/motion.hpp"
#include "verification/case/shape/outline.hpp"
#include "verification/case/shape/tank_shape.hpp"

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

// Calls it with the histories of the surge and the roll, as far as there are any.
void of_each_motion(CaseDefinition& definition, const auto& call) {
  if (definition.motion.surge) call(*definition.motion.surge);
  if (definition.motion.roll) call(definition.motion.roll->angle);
}

void stretch_period(CaseDefinition& definition, double change) {
  const double period = 2 * pi / forcing_frequency(definition);
  const double factor = 1 + change / period;
  of_each_motion(definition, [&](MotionHistory& motion) {
    std::visit([&](auto& one) { stretch(one, factor); }, motion);
  });
  if (definition.declared_forcing_frequency) *definition.declared_forcing_frequency /= factor;
}

// [m] or [deg]
void change_amplitude(CaseDefinition& definition, double change) {
  if (definition.motion.surge) raise_amplitude(*definition.motion.surge, change);
  if (definition.motion.roll) raise_amplitude(definition.motion.roll->angle, change * pi / 180);
}

// In a tank that surges and rolls, both motions start elsewhere.
void change_start(CaseDefinition& definition, double degrees) {
  of_each_motion(definition, [radians = degrees * pi / 180](MotionHistory& motion) {
    if (auto* sine = std::get_if<SineMotion>(&motion))
      sine->phase += radians;
    else if (auto* sum = std::get_if<SumOfSines>(&motion))
      for (SineMotion& one : sum->sines) one.phase += radians;
    else
      throw std::logic_error("a table's start has no phase");
  });
}

void move_gauges(CaseDefinition& definition, double change) {
  for (GaugeDefinition& gauge : definition.gauges) gauge.x += change;
  for (PressureGaugeDefinition& gauge : definition.pressure_gauges) {
    gauge.position += change;
    if (gauge.at) gauge.at = moved_along(definition.tank.outline, *gauge.at, change);
  }
  for (ProbeDefinition& probe : definition.probes) probe.x += change;
}

struct InputRow {
  Input input;
  const char* unit;  // of an amplitude that of a surge
  void (*change)(CaseDefinition&, double);
};

const InputRow input_rows[] = {
    {Input::fill_depth, "m", [](CaseDefinition& it, double by) { it.liquid.fill_depth += by; }},
    {Input::period, "s", stretch_period},
    {Input::amplitude, "m", change_amplitude},
    {Input::start_phase, "deg", change_start},
    {Input::sensor_position, "m", move_gauges},
    {Input::density, "kg/m3", [](CaseDefinition& it, double by) { it.liquid.density += by; }},
    {Input::kinematic_viscosity, "m2/s",
     [](CaseDefinition& it, double by) { it.liquid.kinematic_viscosity += by; }},
    {Input::gravity, "m/s2", [](CaseDefinition& it, double by) { it.gravity += by; }}};

const InputRow& row_of_input(Input input) {
  for (const InputRow& row : input_rows)
    if (row.input == input) return row;
  throw std::logic_error("an input without a row");
}

bool is_possible(const SineMotion& sine) {
  return sine.amplitude > 0 && sine.angular_frequency > 0 && std::isfinite(sine.angular_frequency);
}
bool is_possible(const SumOfSines& sum) {
  return std::all_of(sum.sines.begin(), sum.sines.end(),
                     [](const SineMotion& sine) { return is_possible(sine); });
}
bool is_possible(const TableMotion& table) { return table.time.back() > table.time.front(); }

bool moves(const MotionHistory& motion) {
  return std::visit([](const auto& one) { return is_possible(one); }, motion);
}

// The value, called `what`, that lies outside its range.
std::optional<std::string> outside(const std::string& what, double value, double low, double high) {
  if (value >= low && value <= high) return {};
  return fmt::format("{} = {:.6g}: expected {:.6g} to {:.6g}", what, value, low, high);
}

std::optional<std::string> gauge_outside(const CaseDefinition& definition) {
  const TankDefinition& tank = definition.tank;
  const Extent surface = still_surface(definition);
  for (const GaugeDefinition& gauge : definition.gauges)
    if (auto found = outside(fmt::format("x of gauge {} in m", gauge.name), gauge.x, surface.left,
                             surface.right))
      return found;
  for (const PressureGaugeDefinition& gauge : definition.pressure_gauges) {
    const bool is_level = gauge.wall == Wall::bottom || gauge.wall == Wall::roof;
    if (gauge.at) continue;  // it was moved along the outline
    if (auto found =
            outside(fmt::format("position of pressure gauge {} in m", gauge.name), gauge.position,
                    gauge.width / 2, (is_level ? tank.length : tank.height) - gauge.width / 2))
      return found;
  }
  for (const ProbeDefinition& probe : definition.probes)
    if (auto found =
            outside(fmt::format("x of probe {} in m", probe.name), probe.x, 0, tank.length))
      return found;
  return {};
}

}  // namespace

std::string input_name(Input input) { return name_of(input, input_names); }

std::string input_unit(Input input, const MotionDefinition& motion) {
  return input == Input::amplitude && motion.roll ? "deg" : row_of_input(input).unit;
}

CaseDefinition with_input(CaseDefinition definition, Input input, double change) {
  row_of_input(input).change(definition, change);
  return definition;
}

std::optional<std::string> impossible(const CaseDefinition& definition) {
  const auto& [surge, roll] = definition.motion;
  const double depth = definition.liquid.fill_depth;
  if (!(depth > 0 && depth < definition.tank.height))
    return fmt::format(
        "fill depth = {:.6g} m: expected above 0 and below the tank's height, {:g} m", depth,
        definition.tank.height);
  if (!(definition.liquid.density > definition.gas.density))
    return fmt::format("density = {:.6g} kg/m3: expected above that of the gas, {:g} kg/m3",
                       definition.liquid.density, definition.gas.density);
  for (const auto& [what, value] : {std::pair{"gravity", definition.gravity},
                                    {"kinematic viscosity", definition.liquid.kinematic_viscosity}})
    if (!(value >= 0)) return fmt::format("{} = {:.6g}: expected 0 or more", what, value);
  if ((surge && !moves(*surge)) || (roll && !moves(roll->angle)))
    return "the motion: expected amplitudes and periods above zero";
  return gauge_outside(definition);
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
