// What a particle's step costs in each code.
#include <fmt/format.h>

#include <map>
#include <optional>
#include <string>

#include "reports/tables/case_tables.hpp"
#include "reports/wording/report_places.hpp"
#include "verification/assessment/work_points.hpp"
#include "verification/case/ensemble.hpp"
#include "verification/case/solver_kinds.hpp"

namespace slosh {
namespace {

using reports::Table;

std::string nanoseconds(double seconds, double particle_steps) {
  return fmt::format("{:.3g}", 1e9 * seconds / particle_steps);
}

template <class Values>
std::optional<typename Values::mapped_type> value_of(const Values& values, const char* key) {
  const auto found = values.find(key);
  if (found == values.end()) return std::nullopt;
  return found->second;
}

// Those of interFoam are not Slosh's.
std::string flags_of(const std::map<std::string, std::string>& origin) {
  if (origin.contains("openfoam_version")) return "";
  return value_of(origin, "compiler_flags").value_or("");
}

std::vector<std::string> row_of(const std::string& run, const RunResult& result,
                                double core_seconds_of_run) {
  const auto loop = value_of(result.diagnostics, "loop_processor_time_s");
  const auto walls = value_of(result.diagnostics, "wall_particles");
  const auto evaluations = value_of(result.diagnostics, "evaluations_per_step");
  const auto sound = value_of(result.diagnostics, "speed_of_sound_m_s");
  const double seconds = loop.value_or(core_seconds_of_run);
  const double liquid = result.cost.elements, steps = result.cost.steps;
  return {run,
          fmt::format("{:.0f}", liquid),
          walls ? fmt::format("{:.0f}", *walls) : "",
          fmt::format("{:.0f}", steps),
          evaluations ? fmt::format("{:.0f}", *evaluations) : "",
          loop ? "time loop" : "whole run",
          nanoseconds(seconds, liquid * steps),
          walls ? nanoseconds(seconds, (liquid + *walls) * steps) : "",
          sound ? fmt::format("{:.3g}", *sound) : "",
          flags_of(result.provenance)};
}

}  // namespace

std::optional<Table> step_table(const CaseAssessment& assessment) {
  Table table{case_id(assessment.definition.name) + "-step-table",
              "Cost of a particle's step",
              "Core-seconds over the number of steps and of particles: those of the liquid, or "
              "cells, and those of the liquid and the walls. A code that tells the time of its "
              "time loop is counted by that, another by the whole run. What a code does not tell "
              "is blank.",
              {"run", "liquid particles or cells", "wall particles", "steps",
               "evaluations of the forces per step", "counted", "per liquid particle and step [ns]",
               "per particle and step [ns]", "speed of sound [m/s]", "compiler flags"},
              {}};
  const CaseRuns& runs = assessment.runs;
  bool compares_codes = false;
  for (const RunDefinition& run : assessment.definition.runs) {
    const auto result = runs.results.find(run.name);
    if (is_later_member(run) || !is_simulation(run) || result == runs.results.end()) continue;
    const RunCost& cost = result->second.cost;
    if (!(cost.elements > 0 && cost.steps > 0)) continue;
    compares_codes =
        compares_codes || std::holds_alternative<ExternalRun>(run.solver) || is_stored(run);
    table.rows.push_back(
        row_of(run.name, result->second, cost_of(runs, run.name).core_seconds.value));
  }
  if (!compares_codes) return std::nullopt;
  return table;
}

}  // namespace slosh
