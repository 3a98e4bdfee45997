#include "verification/evidence/input_uncertainty.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "verification/case/changed_input.hpp"
#include "verification/case/metric_table.hpp"
#include "verification/case/motion.hpp"
#include "verification/case/shape/tank_shape.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/evidence/row_uncertainty.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/solvers/theory/natural_frequencies.hpp"

namespace slosh {
namespace {

// The first theory inside its range that has the liquid alone, without the gas. Returns nullptr
// where there is none.
const RunDefinition* theory_in_range(const CaseDefinition& definition, const CaseRuns& runs) {
  for (const RunDefinition& run : definition.runs) {
    const auto status = runs.status.find(run.name);
    if (is_theory(run) && !sees_gas(run) && status != runs.status.end() &&
        status->second.state == RunState::finished)
      return &run;
  }
  return nullptr;
}

RunResult predicted(const CaseDefinition& definition, const RunDefinition& theory, Input input,
                    double change) {
  RunSettings settings;
  settings.with_left_out = false;
  return execute(with_input(definition, input, change), theory, settings, [](double, double) {});
}

bool is_open(const RunStatus& status) {
  return status.state == RunState::failed || status.state == RunState::missing;
}

// The number of half waves of the shortest wave that carries much: that of the initial wave, or
// the one that the fastest part of the motion is nearest to.
int half_waves(const CaseDefinition& definition) {
  double fastest = 0;
  for (const ForcedMode& mode : forced_modes(definition))
    fastest = std::max(fastest, mode.angular_frequency);
  constexpr int most_in_rectangle = 64;
  const std::vector<double> natural =
      natural_frequencies(definition, is_rectangle(definition.tank) ? most_in_rectangle : 1);
  const auto slower =
      std::count_if(natural.begin(), natural.end(), [=](double one) { return one < fastest; });
  return std::max(1 + static_cast<int>(slower),
                  definition.initial_wave ? definition.initial_wave->mode : 1);
}

// The change of an input within which the response repeats itself: a whole turn of the start, a
// wave's length, or what moves the phase at the window's end by a turn. That to the others is
// monotone.
double repeats_after(const CaseDefinition& definition, Input input) {
  const int waves = half_waves(definition);
  const auto turns_at = [&](double frequency) {  // by the window's end
    return std::max(1.0, definition.window_end * frequency / (2 * std::numbers::pi));
  };
  const auto natural_turns = [&] {
    const std::vector<double> natural = natural_frequencies(definition, waves);
    return turns_at(natural.empty() ? 0 : natural.back());
  };
  switch (input) {
    case Input::start_phase:
      return 360;
    case Input::sensor_position:
      return 2 * definition.tank.length / waves;
    case Input::period:
      return 2 * std::numbers::pi / forcing_frequency(definition) /
             turns_at(forcing_frequency(definition));
    case Input::fill_depth:  // d omega / omega <= dh / 2 h
      return 2 * definition.liquid.fill_depth / natural_turns();
    case Input::gravity:  // d omega / omega = dg / 2 g
      return 2 * definition.gravity / natural_turns();
    case Input::amplitude:
    case Input::density:
    case Input::kinematic_viscosity:
      break;
  }
  return std::numeric_limits<double>::infinity();
}

// Throws ComparisonError where the input's bounds are not predicted.
const InputBounds& bounds_of(const CaseDefinition& definition, const CaseRuns& runs,
                             const InputUncertainty& one) {
  for (const double change : {-one.half_width, one.half_width})
    if (const auto why = impossible(with_input(definition, one.input, change)))
      throw ComparisonError("a bound of its interval is impossible: " + *why);
  if (const auto bounds = runs.input_bounds.find(one.input); bounds != runs.input_bounds.end())
    return bounds->second;
  const auto why = runs.not_predicted.find(one.input);
  throw ComparisonError(
      why != runs.not_predicted.end()
          ? why->second
          : "no theory of the liquid alone predicts the case at both bounds, and no coarse_run was "
            "computed at both");
}

// Two runs at the bounds show a response that turns only where they are so near.
constexpr double most_for_two_runs = 1.0 / 20;
// Theory is asked so often while the response repeats itself once.
constexpr double places_of_a_repeat = 32;

// The changes of the input that theory shows beside the bounds of its half width: as many as the
// response needs, up to one that repeats itself once. A start that may be anywhere is half a turn
// wide. Throws ComparisonError for any other input that wide.
std::vector<double> between_bounds(const CaseDefinition& definition, const InputUncertainty& one) {
  const double repeat = repeats_after(definition, one.input);
  const bool is_anywhere = one.half_width > repeat / 2;
  if (is_anywhere && one.input != Input::start_phase)
    throw ComparisonError(fmt::format(
        "its half width of {:.4g} {unit} exceeds {:.4g} {unit}, half of what the waves repeat "
        "themselves within",
        one.half_width, repeat / 2, fmt::arg("unit", input_unit(one.input, definition.motion))));
  const double half = is_anywhere ? repeat / 2 : one.half_width;
  const int steps = static_cast<int>(std::ceil(2 * half / repeat * places_of_a_repeat));
  std::vector<double> changes;
  for (int i = is_anywhere ? 0 : 1; i < steps; ++i)
    if (2 * i != steps) changes.push_back(half * (2.0 * i / steps - 1));
  return changes;
}

// The largest change of the metric from its own value, between each prediction and the case as it
// is.
double largest_change(const CaseDefinition& definition, const CaseRuns& runs,
                      const InputUncertainty& one, const GateRow& row,
                      const MeasureWithSeries& measure_with) {
  if (is_of_repeats(row.metric))
    throw ComparisonError(
        "a distribution has no prediction at both bounds; an ensemble with vary_inputs = true "
        "would count it");
  const InputBounds& bounds = bounds_of(definition, runs, one);
  const auto own = runs.results.find(bounds.own);
  if (own == runs.results.end()) throw ComparisonError("there is no result of " + bounds.own);
  const auto value = [&](const RunResult& predicted) {
    return measure_with(row, row.candidate, predicted.at(row.quantity)).value;
  };
  constexpr double turn = 360;
  double largest = 0;
  if (bounds.between.empty() &&
      one.half_width > repeats_after(definition, one.input) * most_for_two_runs)
    throw ComparisonError(
        "two runs at the bounds of so wide an interval do not show how the metric turns between");
  std::vector<const RunResult*> all{&bounds.lower, &bounds.upper};
  for (const RunResult& one : bounds.between) all.push_back(&one);
  for (const RunResult* one : all) {
    double change = value(*one) - value(own->second);
    if (is_angle(row.metric)) change = std::remainder(change, turn);
    if (!std::isfinite(change)) throw ComparisonError("the prediction has no such metric");
    largest = std::max(largest, std::abs(change));
  }
  return largest;
}

}  // namespace

void predict_input_bounds(const CaseDefinition& definition, CaseRuns& runs) {
  const bool is_needed =
      std::any_of(definition.gate.begin(), definition.gate.end(),
                  [&](const GateRow& row) { return rests_on_experiment(definition, row); });
  const RunDefinition* theory = theory_in_range(definition, runs);
  if (!is_needed || !theory) return;
  for (const InputUncertainty& one : definition.inputs) {
    try {
      const auto at = [&](double change) {
        return predicted(definition, *theory, one.input, change);
      };
      const std::vector<double> between = between_bounds(definition, one);
      InputBounds bounds{at(-one.half_width), at(one.half_width), {}, theory->name};
      for (const double change : between) bounds.between.push_back(at(change));
      runs.input_bounds[one.input] = std::move(bounds);
    } catch (const std::exception& error) {
      runs.not_predicted[one.input] = error.what();
    }
  }
}

void collect_input_bounds(CaseDefinition& definition, CaseRuns& runs) {
  std::map<Input, std::map<bool, RunResult>> ends;  // by input; true: at the upper bound
  std::map<Input, std::string> repeated;
  const std::vector<RunDefinition> all = std::move(definition.runs);
  definition.runs.clear();
  for (const RunDefinition& run : all) {
    if (!run.at_input || is_open(runs.status.at(run.name))) {
      definition.runs.push_back(run);
      continue;
    }
    repeated[run.at_input->input] = run.at_input->repeated_run;
    if (const auto result = runs.results.extract(run.name))
      ends[run.at_input->input][run.at_input->change > 0] = result.mapped();
    runs.status.erase(run.name);
    runs.timings.erase(run.name);
  }
  for (auto& [input, found] : ends)
    if (found.size() == 2 && !runs.input_bounds.contains(input))
      runs.input_bounds[input] = {
          std::move(found[false]), std::move(found[true]), {}, repeated[input]};
}

Contribution input_uncertainty(const CaseDefinition& definition, const CaseRuns& runs,
                               const GateRow& row, const MeasureWithSeries& measure_with) {
  if (definition.inputs.empty())
    return Contribution::unknown(
        "the uncertainty of the experiment's inputs is unknown: the case declares no [[input]]");
  double squares = 0;
  std::vector<std::string> counted, not_counted;
  for (const InputUncertainty& one : definition.inputs) {
    try {
      const double change = largest_change(definition, runs, one, row, measure_with);
      squares += change * change;
      counted.push_back(fmt::format("{} {}", input_name(one.input), in_unit(change, row.unit)));
    } catch (const std::runtime_error& error) {  // ComparisonError and ResultError
      not_counted.push_back(
          fmt::format("the sensitivity to {} is unknown: {}", input_name(one.input), error.what()));
    }
  }
  const std::string missing = fmt::format("{}", fmt::join(not_counted, "; "));
  Contribution found = counted.empty() ? Contribution::unknown(missing)
                                       : Contribution(std::sqrt(squares),
                                                      fmt::format("{}", fmt::join(counted, ", ")));
  found.not_counted = missing;
  return found;
}

}  // namespace slosh
