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
#include "verification/case/solver_kinds.hpp"
#include "verification/evidence/row_uncertainty.hpp"
#include "verification/runs/run_case.hpp"

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
  return execute(with_input(definition, input, change), theory, {}, [](double, double) {});
}

bool is_open(const RunStatus& status) {
  return status.state == RunState::failed || status.state == RunState::missing;
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

// Where the response turns between the bounds, theory shows it at these shares of the half width,
// which no whole number of periods hits all.
constexpr double between_bounds[] = {-0.618, 0.382};

// Two runs at the bounds do not show it: their half width may be a twentieth of what the response
// can turn within. That to the others is monotone.
double turns_within(const CaseDefinition& definition, Input input) {
  switch (input) {
    case Input::fill_depth:
      return definition.liquid.fill_depth;
    case Input::period:
      return 2 * std::numbers::pi / forcing_frequency(definition);
    case Input::gravity:
      return definition.gravity;
    case Input::sensor_position:
      return definition.tank.length;
    case Input::start_phase:
      return 360;
    case Input::amplitude:
    case Input::density:
    case Input::kinematic_viscosity:
      break;
  }
  return std::numeric_limits<double>::infinity();
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
  if (bounds.between.empty() && one.half_width > turns_within(definition, one.input) / 20)
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
      runs.input_bounds[one.input] = {predicted(definition, *theory, one.input, -one.half_width),
                                      predicted(definition, *theory, one.input, one.half_width),
                                      {},
                                      theory->name};
      for (const double share : between_bounds)
        runs.input_bounds[one.input].between.push_back(
            predicted(definition, *theory, one.input, share * one.half_width));
    } catch (const std::exception& error) {
      runs.input_bounds.erase(one.input);
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
