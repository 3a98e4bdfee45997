#include "verification/campaign/input_uncertainty.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verification/campaign/replaced_series.hpp"
#include "verification/campaign/row_uncertainty.hpp"
#include "verification/case_file/inputs.hpp"
#include "verification/case_file/motion.hpp"
#include "verification/runs/run_case.hpp"

namespace slosh {
namespace {

using std::numbers::pi;

void stretch_time(MotionHistory& motion, double factor) {
  if (auto* sine = std::get_if<SineMotion>(&motion)) {
    sine->angular_frequency /= factor;
  } else {
    for (double& time : std::get<TableMotion>(motion).time) time *= factor;
  }
}

// `change` in the motion's own unit.
void raise_amplitude(MotionHistory& motion, double change) {
  if (auto* sine = std::get_if<SineMotion>(&motion)) {
    sine->amplitude += change;
    return;
  }
  std::vector<double>& values = std::get<TableMotion>(motion).value;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double factor = 1 + change / std::max(std::abs(*low), std::abs(*high));
  for (double& value : values) value *= factor;
}

void stretch_period(CaseDefinition& definition, double change) {
  const double period = 2 * pi / forcing_frequency(definition);
  const double factor = 1 + change / period;
  if (definition.motion.surge) stretch_time(*definition.motion.surge, factor);
  if (definition.motion.roll) stretch_time(definition.motion.roll->angle, factor);
  if (definition.declared_forcing_frequency) *definition.declared_forcing_frequency /= factor;
}

void move_gauges(CaseDefinition& definition, double change) {
  for (GaugeDefinition& gauge : definition.gauges) gauge.x += change;
  for (PressureGaugeDefinition& gauge : definition.pressure_gauges) gauge.position += change;
}

// Of the candidate's liquid alone, without the gas: a tank of one layer.
const RunDefinition* theory_in_range(const CaseDefinition& definition, const CaseRuns& runs) {
  for (const RunDefinition& run : definition.runs) {
    const auto* linear = std::get_if<LinearRun>(&run.solver);
    const bool is_theory =
        (linear && !linear->two_layer) || std::holds_alternative<PotentialRun>(run.solver);
    const auto status = runs.status.find(run.name);
    if (is_theory && status != runs.status.end() && status->second.state == RunState::finished)
      return &run;
  }
  return nullptr;
}

RunResult predicted(const CaseDefinition& definition, const RunDefinition& theory, Input input,
                    double change) {
  return execute(with_input(definition, input, change), theory, {}, [](double, double) {});
}

}  // namespace

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
  }
  return definition;
}

std::map<Input, InputBounds> predict_input_bounds(const CaseDefinition& definition,
                                                  const CaseRuns& runs) {
  std::map<Input, InputBounds> bounds;
  const bool is_needed =
      std::any_of(definition.gate.begin(), definition.gate.end(),
                  [&](const GateRow& row) { return rests_on_experiment(definition, row); });
  const RunDefinition* theory = theory_in_range(definition, runs);
  if (!is_needed || !theory) return bounds;
  for (const InputUncertainty& one : definition.inputs) {
    try {
      bounds[one.input] = {predicted(definition, *theory, one.input, -one.half_width),
                           predicted(definition, *theory, one.input, one.half_width)};
    } catch (const std::exception&) {
      continue;  // the tank is none at that end: the row then says that no theory holds
    }
  }
  return bounds;
}

Contribution input_uncertainty(const CaseDefinition& definition, const CaseRuns& runs,
                               const GateRow& row) {
  if (definition.inputs.empty())
    return Contribution::unknown(
        "the uncertainty of the experiment's inputs is unknown: the case declares no [[input]]");
  double squares = 0;
  std::vector<std::string> parts;
  for (const InputUncertainty& one : definition.inputs) {
    const auto bounds = runs.input_bounds.find(one.input);
    try {
      if (bounds == runs.input_bounds.end())
        throw ComparisonError("no theory of the case holds there");
      const auto value = [&](const RunResult& at_bound) {
        return measured_with(definition, runs, row, row.candidate, at_bound.at(row.quantity)).value;
      };
      const double half = (value(bounds->second.upper) - value(bounds->second.lower)) / 2;
      if (!std::isfinite(half)) throw ComparisonError("theory has no such metric");
      squares += half * half;
      parts.push_back(
          fmt::format("{} {}", input_name(one.input), in_unit(std::abs(half), row.unit)));
    } catch (const std::runtime_error& error) {  // ComparisonError and ResultError
      return Contribution::unknown(
          fmt::format("the sensitivity to {} is unknown: {}", input_name(one.input), error.what()));
    }
  }
  return {std::sqrt(squares), fmt::format("{}", fmt::join(parts, ", "))};
}

}  // namespace slosh
