#include "verification/evidence/soundness.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "verification/case/quantities.hpp"

namespace slosh {
namespace {

// Of a run's diagnostics.
struct SoundnessLimit {
  const char *fact, *name;
  double limit;
  bool is_share;  // shown in percent
  bool needs_weight = false;
};
constexpr SoundnessLimit soundness_limits[] = {
    {"largest_mach_number", "largest Mach number", 0.2, false},
    {"largest_density_error", "largest density error", 0.05, true},
    {"largest_packing_drift", "largest packing drift", 0.01, true},
    {"largest_tension_share", "largest share of particles under tension", 0.5, true, true},
    {"max_courant_number", "largest Courant number", 1, false}};

double weight_of_column(const CaseDefinition& definition) {
  return definition.liquid.density * definition.gravity * definition.liquid.fill_depth;
}

std::vector<std::string> doubts_of_facts(const CaseDefinition& definition,
                                         const RunResult& result) {
  std::vector<std::string> doubts;
  for (const SoundnessLimit& one : soundness_limits) {
    const auto found = result.diagnostics.find(one.fact);
    if (found == result.diagnostics.end() || found->second <= one.limit) continue;
    if (one.needs_weight && definition.gravity == 0) continue;
    const auto shown = [&](double value) {
      return one.is_share ? in_unit(value, "1") : fmt::format("{:.2g}", value);
    };
    doubts.push_back(
        fmt::format("its {} is {}, limit {}", one.name, shown(found->second), shown(one.limit)));
  }
  return doubts;
}

// The filter hides what the sensor reads.
std::vector<std::string> doubts_of_walls(const CaseDefinition& definition,
                                         const RunResult& result) {
  std::vector<std::string> doubts;
  const double least = -weight_of_column(definition);
  for (const PressureGaugeDefinition& gauge : definition.pressure_gauges)
    for (const TimeSeries& one : result.series) {
      if (one.name != wall_pressure(gauge.name) || one.value.empty() || least == 0) continue;
      const double lowest = *std::min_element(one.value.begin(), one.value.end());
      if (!(lowest >= least))
        doubts.push_back(
            fmt::format("its {} falls to {:.3g} Pa, limit {:.3g} Pa", one.name, lowest, least));
    }
  return doubts;
}

}  // namespace

std::string soundness_doubt(const CaseDefinition& definition, const CaseRuns& runs,
                            const std::string& run) {
  const auto result = runs.results.find(run);
  const auto& solver = run_named(definition, run).solver;
  const bool is_judged =
      std::holds_alternative<SphRun>(solver) || std::holds_alternative<InterFoamRun>(solver);
  if (!is_judged || result == runs.results.end()) return "";
  std::vector<std::string> doubts = doubts_of_facts(definition, result->second);
  for (std::string& one : doubts_of_walls(definition, result->second))
    doubts.push_back(std::move(one));
  return doubts.empty() ? "" : fmt::format("{} is not sound: {}", run, fmt::join(doubts, ", "));
}

std::string doubtful_runs(const CaseDefinition& definition, const CaseRuns& runs) {
  std::string first;
  int others = 0;
  for (const RunDefinition& run : definition.runs) {
    const std::string doubt = soundness_doubt(definition, runs, run.name);
    if (doubt.empty()) continue;
    if (first.empty())
      first = fmt::format("doubtful: {}: {}", definition.name, doubt);
    else
      ++others;
  }
  return others == 0 ? first
                     : fmt::format("{}; so {} {} of its other runs", first,
                                   others == 1 ? "is" : "are", others);
}

}  // namespace slosh
