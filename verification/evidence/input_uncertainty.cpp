#include "verification/evidence/input_uncertainty.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "verification/case/changed_input.hpp"
#include "verification/case/metric_table.hpp"
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

}  // namespace

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
      continue;  // the tank is impossible at that bound; the row then says that no theory predicts
                 // it
    }
  }
  return bounds;
}

void collect_input_bounds(CaseDefinition& definition, CaseRuns& runs) {
  std::map<Input, std::map<bool, RunResult>> ends;  // by input; true: at the upper bound
  const std::vector<RunDefinition> all = std::move(definition.runs);
  definition.runs.clear();
  for (const RunDefinition& run : all) {
    if (!run.at_input || is_open(runs.status.at(run.name))) {
      definition.runs.push_back(run);
      continue;
    }
    if (const auto result = runs.results.extract(run.name))
      ends[run.at_input->input][run.at_input->change > 0] = result.mapped();
    runs.status.erase(run.name);
    runs.timings.erase(run.name);
  }
  for (auto& [input, found] : ends)
    if (found.size() == 2 && !runs.input_bounds.contains(input))
      runs.input_bounds[input] = {std::move(found[false]), std::move(found[true])};
}

Contribution input_uncertainty(const CaseDefinition& definition, const CaseRuns& runs,
                               const GateRow& row, const MeasureWithSeries& measure_with) {
  if (definition.inputs.empty())
    return Contribution::unknown(
        "the uncertainty of the experiment's inputs is unknown: the case declares no [[input]]");
  if (is_of_repeats(row.metric))
    return Contribution::unknown(
        "the effect of the inputs on a distribution is unknown; an ensemble with vary_inputs = "
        "true "
        "would count it");
  double squares = 0;
  std::vector<std::string> parts;
  for (const InputUncertainty& one : definition.inputs) {
    const auto bounds = runs.input_bounds.find(one.input);
    try {
      if (bounds == runs.input_bounds.end())
        throw ComparisonError(
            "no theory of the liquid alone predicts the case at both bounds, and no coarse_run was "
            "computed at both");
      const auto value = [&](const RunResult& at_bound) {
        return measure_with(row, row.candidate, at_bound.at(row.quantity)).value;
      };
      const double half = (value(bounds->second.upper) - value(bounds->second.lower)) / 2;
      if (!std::isfinite(half)) throw ComparisonError("the prediction has no such metric");
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
