// One of the effects that the models of a case leave out, and the cases of such tests.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/assessment/doubts/model_limits.hpp"
#include "verification/tests/sample_case.hpp"

namespace slosh {

inline CaseDefinition case_with_runs(const std::vector<decltype(RunDefinition::solver)>& solvers) {
  CaseDefinition definition = sample_case();
  for (const auto& solver : solvers) definition.runs.push_back(sample_run(solver));
  return definition;
}

// The surge has the first natural frequency of the tank, and a gauge on the roof measures impacts.
inline CaseDefinition violent_case(const std::vector<decltype(RunDefinition::solver)>& solvers) {
  CaseDefinition definition = case_with_runs(solvers);
  definition.motion.surge = SineMotion{.amplitude = 0.02, .angular_frequency = 4.94488};
  definition.pressure_gauges = {{.name = "R", .wall = Wall::roof, .position = 0.1}};
  return definition;
}

// Returns the first whose effect contains the text.
inline std::optional<ModelLimit> found_limit(const CaseDefinition& definition,
                                             const std::string& effect, const CaseRuns& runs = {}) {
  for (const ModelLimit& limit : model_limits(definition, runs))
    if (limit.effect.find(effect) != std::string::npos) return limit;
  return std::nullopt;
}

}  // namespace slosh
