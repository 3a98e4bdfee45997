#include "verification/campaign/expected_cost.hpp"

#include <algorithm>
#include <cmath>

#include "verification/runs/result_file.hpp"

namespace slosh {
namespace {

constexpr double mebibyte = 1024 * 1024;

// Within a factor of three of what two-core machines took; memory above what any run took there.
ExpectedCost rule_of_thumb(const CaseDefinition& definition, const RunDefinition& run) {
  const double area = definition.liquid.column_width.value_or(definition.tank.length) *
                      definition.liquid.fill_depth;
  ExpectedCost cost{.processor_time = 1, .wall_time = 0, .memory = 64 * mebibyte};
  if (const auto* sph = std::get_if<SphRun>(&run.solver)) {
    cost.processor_time = definition.duration * 2e-6 * area / std::pow(sph->particle_spacing, 3);
    cost.memory += 2048 * area / std::pow(sph->particle_spacing, 2);
  } else if (const auto* mesh = std::get_if<InterFoamRun>(&run.solver)) {
    cost.processor_time = definition.duration * 5e-4 * mesh->cells_x * mesh->cells_z;
    cost.memory += 128 * mebibyte + 8192.0 * mesh->cells_x * mesh->cells_z;
    cost.cores = mesh->processes;
  } else if (std::holds_alternative<PotentialRun>(run.solver)) {
    cost.processor_time = definition.duration;
  } else if (const auto* external = std::get_if<ExternalRun>(&run.solver)) {
    constexpr double unknown = 3600;  // [s]: better early in the queue than last
    cost.processor_time = external->time_limit.value_or(unknown);
  }
  cost.wall_time = cost.processor_time / cost.cores;
  return cost;
}

}  // namespace

ExpectedCost expected_cost(const CaseDefinition& definition, const RunDefinition& run,
                           const std::string& key, const ResultStore& store) {
  ExpectedCost cost = rule_of_thumb(definition, run);
  const auto earlier = store.newest_file(key, ".h5");
  if (!earlier) return cost;
  try {
    const RunCost taken = read_result(*earlier).cost;
    cost.processor_time = taken.user_time + taken.system_time;
    cost.wall_time = taken.wall_time;
    cost.memory = taken.peak_memory;
    cost.measured = true;
  } catch (const ResultError&) {  // damaged: it says nothing
  }
  return cost;
}

double time_limit(const ExpectedCost& cost) {
  constexpr double shortest = 600;  // [s]
  return std::max(shortest, 20 * cost.wall_time);
}

}  // namespace slosh
