#include "verification/runs/expected_cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "verification/case/shape/tank_shape.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/runs/cost_model.hpp"
#include "verification/runs/cost_records.hpp"
#include "verification/runs/run_case.hpp"

namespace slosh {
namespace {

constexpr double mebibyte = 1024 * 1024;

// The factors by which the model may be wrong. On a machine without recorded runs it is larger: the
// same machine took twice as long crowded as idle.
constexpr double of_known_machine = 1.5, of_unknown_machine = 2;

// Nothing is known of what an external program does.
bool can_be_modelled(const RunDefinition& run) {
  return solver_kind(run).answered_with != AnsweredWith::user_program;
}

// The estimated memory is above that of any run measured on two-core machines.
ExpectedCost estimate(const CaseDefinition& definition, const RunDefinition& run,
                      const ResultStore& store) {
  const std::optional<double> factor = machine_factor(solver_name(run), store);
  ExpectedCost cost{.processor_time = factor.value_or(1) * modelled_time(definition, run),
                    .wall_time = 0,
                    .memory = 64 * mebibyte,
                    .uncertainty = factor ? of_known_machine : of_unknown_machine};
  if (const auto* sph = std::get_if<SphRun>(&run.solver)) {
    cost.memory += 2048 * liquid_area(definition) / std::pow(sph->particle_spacing, 2);
  } else if (const auto* mesh = std::get_if<InterFoamRun>(&run.solver)) {
    cost.memory += 128 * mebibyte + 8192 * number_of_cells(*mesh);
    cost.cores = mesh->processes;
  } else if (const auto* external = std::get_if<ExternalRun>(&run.solver)) {
    cost.processor_time = cost.memory = cost.uncertainty = 0;
    cost.cores = external->cores.value_or(1);
    cost.own_limit = external->time_limit;
  }
  cost.wall_time = cost.processor_time / cost.cores;
  return cost;
}

// Writes two digits, or whole seconds.
std::string seconds_text(double seconds) {
  return seconds < 10 ? fmt::format("{:.2g}", seconds) : fmt::format("{:.0f}", seconds);
}

}  // namespace

ExpectedCost expected_cost(const CaseDefinition& definition, const RunDefinition& run,
                           const std::string& key, const ResultStore& store) {
  ExpectedCost cost = estimate(definition, run, store);
  const auto earlier = store.newest_file(key, ".h5");
  if (!earlier) return cost;
  try {
    const RunCost taken = read_result(*earlier).cost;
    cost.processor_time = taken.core_seconds();
    cost.wall_time = taken.wall_time;
    cost.memory = taken.peak_memory;
    cost.measured = true;
    cost.uncertainty = 1;
  } catch (const ResultError&) {  // the file is damaged and says nothing
  }
  return cost;
}

void learn_cost(const RunResult& result, const CaseDefinition& definition, const RunDefinition& run,
                const ResultStore& store) {
  const bool ended_early = result.provenance.contains("left_range_because");
  if (ended_early || !can_be_modelled(run)) return;
  record_cost({.solver = solver_name(run),
               .modelled = modelled_time(definition, run),
               .taken = result.cost.core_seconds()},
              store);
}

std::string cost_text(const ExpectedCost& cost) {
  const double taken = cost.processor_time;
  if (cost.measured) return fmt::format("{} core-seconds measured", seconds_text(taken));
  if (cost.uncertainty == 0) return "core-seconds not known";
  return fmt::format("about {} core-seconds, an estimate: {} to {}", seconds_text(taken),
                     seconds_text(taken / cost.uncertainty),
                     seconds_text(taken * cost.uncertainty));
}

double time_limit(const ExpectedCost& cost) {
  constexpr double shortest = 600, of_unknown = 72000;  // [s]
  // The run's own limit ends it first, and says so; its version_command may take a minute before.
  constexpr double beyond_own = 120;  // [s]
  if (cost.own_limit) return std::max(shortest, *cost.own_limit + beyond_own);
  const bool unknown = !cost.measured && cost.uncertainty == 0;
  return unknown ? of_unknown : std::max(shortest, 20 * cost.wall_time);
}

}  // namespace slosh
