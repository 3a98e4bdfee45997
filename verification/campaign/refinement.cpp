#include "verification/campaign/refinement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace slosh {
namespace {

double recorded(const RunDefinition& run, const CaseRuns& runs, const char* name) {
  const auto& diagnostics = runs.results.at(run.name).diagnostics;
  const auto found = diagnostics.find(name);
  if (found == diagnostics.end())
    throw ComparisonError(fmt::format("the result of {} does not tell its {}", run.name, name));
  return found->second;
}

GateRow with(GateRow row, Role role, const std::string& run) {
  (role == Role::candidate ? row.candidate : row.reference) = run;
  return row;
}

DiscretisationUncertainty of_two(const ValueAtStep& fine, const ValueAtStep& coarse) {
  const double difference =
      std::max(std::abs(coarse.value - fine.value), std::hypot(coarse.noise, fine.noise));
  return {.behaviour = StepBehaviour::diverging,
          .order = {},
          .extrapolated = fine.value,
          .uncertainty = 3 * difference / std::min(1.0, coarse.step / fine.step - 1),
          .explanation =
              "two values have no order: three times their difference on one of the first order"};
}

// Coarse to fine.
DiscretisationUncertainty judge(const std::vector<ValueAtStep>& values) {
  return values.size() == 2 ? of_two(values[1], values[0]) : discretisation_uncertainty(values);
}

}  // namespace

double step_of(RefinedNumber number, const RunDefinition& run, const CaseRuns& runs) {
  switch (number) {
    case RefinedNumber::particle_spacing:
      return std::get<SphRun>(run.solver).particle_spacing;
    case RefinedNumber::smoothing_length_ratio:
      return 1 / recorded(run, runs, "smoothing_length_ratio");
    case RefinedNumber::speed_of_sound:
      return 1 / recorded(run, runs, "speed_of_sound_m_s");
    case RefinedNumber::courant_number:
      return recorded(run, runs, "courant_number");
    case RefinedNumber::mesh: {
      const InterFoamRun& mesh = std::get<InterFoamRun>(run.solver);
      return 1 / std::sqrt(static_cast<double>(mesh.cells_x) * mesh.cells_z);
    }
  }
  throw std::logic_error("a refined number without a step");
}

std::vector<RefinedMetric> refined_metrics(const CaseDefinition& definition, const CaseRuns& runs,
                                           const GateRow& row, Role role,
                                           const MeasureRow& measure) {
  const std::string& own = role == Role::candidate ? row.candidate : row.reference;
  std::vector<RefinedMetric> metrics;
  for (const RefinementDefinition& path : definition.refinements) {
    if (std::find(path.runs.begin(), path.runs.end(), own) == path.runs.end()) continue;
    const double own_step = step_of(path.number, run_named(definition, own), runs);
    std::vector<std::pair<ValueAtStep, std::string>> measured;
    for (const std::string& name : path.runs) {
      if (!runs.results.contains(name)) continue;
      const double step = step_of(path.number, run_named(definition, name), runs);
      if (step < own_step) continue;
      try {
        const Estimate value = measure(with(row, role, name));
        if (std::isfinite(value.value) && std::isfinite(value.half_width))
          measured.push_back({{step, value.value, value.half_width}, name});
      } catch (const std::runtime_error&) {
        continue;  // ComparisonError or ResultError: this run has no such metric
      }
    }
    if (measured.size() < 2) continue;
    std::sort(measured.begin(), measured.end(),
              [](const auto& a, const auto& b) { return a.first.step > b.first.step; });
    RefinedMetric metric{path.name, {}, {}, {}};
    for (const auto& [value, name] : measured) {
      metric.values.push_back(value);
      metric.runs.push_back(name);
    }
    metric.found = judge(metric.values);
    metrics.push_back(std::move(metric));
  }
  return metrics;
}

double numerical_uncertainty(const std::vector<RefinedMetric>& paths) {
  double squares = 0;
  for (const RefinedMetric& path : paths)
    squares += path.found.uncertainty * path.found.uncertainty;
  return std::sqrt(squares);
}

}  // namespace slosh
