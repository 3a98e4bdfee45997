#include "verification/runs/expected_cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <variant>

#include "verification/case/changed_input.hpp"
#include "verification/case/shape/tank_shape.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/files/foreign/plain_file.hpp"
#include "verification/files/protected_inputs.hpp"
#include "verification/runs/sph_step.hpp"

namespace slosh {
namespace {

std::filesystem::path file_of(const ResultStore& store) { return store.root() / "costs.txt"; }

// What a run computes, comparable between the runs of a kind alone.
struct Size {
  double elements = 0, steps = 0;  // 0: not known
};

Size size_of(const SphRun& sph, const CaseDefinition& definition, const RunDefinition& run) {
  const std::optional<SphStep> step = sph_step(definition, run);
  const double spacing = sph.surface_particle_spacing;
  return {liquid_area(definition) / (spacing * spacing),
          step ? definition.duration / step->between_samples : 0};
}

// The step follows the size of a cell.
Size size_of(const InterFoamRun& mesh, const CaseDefinition& definition, const RunDefinition&) {
  return {number_of_cells(mesh), definition.duration * mesh.cells_x / definition.tank.length};
}

Size size_of(const PotentialRun& flow, const CaseDefinition& definition, const RunDefinition&) {
  return {static_cast<double>(flow.nodes_x) * flow.nodes_z,
          definition.duration / definition.sample_interval};
}

Size size_of(const LinearRun& linear, const CaseDefinition& definition, const RunDefinition&) {
  return {static_cast<double>(linear.modes), definition.duration / definition.sample_interval};
}

Size size_of(const ExternalRun&, const CaseDefinition&, const RunDefinition&) { return {}; }

// The others take the start of a process and the reading of a file.
template <typename Solver>
Size size_of(const Solver&, const CaseDefinition&, const RunDefinition&) {
  return {1, 1};
}

Size size_of(const CaseDefinition& definition, const RunDefinition& run) {
  const CaseDefinition solved = definition_solved_by(run, definition);
  return std::visit([&](const auto& solver) { return size_of(solver, solved, run); }, run.solver);
}

struct CostRecord {
  Size size;
  double processor_time, memory;  // [s], [byte]
};

// Returns the newest record of the kind. A line is "ELEMENTS STEPS SECONDS BYTES KIND".
std::optional<CostRecord> last_record(const std::string& kind, const ResultStore& store) {
  std::optional<CostRecord> last;
  if (!is_plain_file(file_of(store))) return last;  // a pipe would be waited for
  std::ifstream file(file_of(store));
  for (std::string line, name; std::getline(file, line);) {
    std::istringstream words(line);
    CostRecord one{};
    words >> one.size.elements >> one.size.steps >> one.processor_time >> one.memory >> std::ws;
    if (std::getline(words, name) && name == kind && one.size.elements > 0 && one.size.steps > 0)
      last = one;
  }
  return last;
}

// A smaller run is not expected to take less memory, much of which does not grow with the elements.
void scale(ExpectedCost& cost, const CostRecord& record, const Size& size) {
  const double elements = size.elements / record.size.elements;
  cost.processor_time = record.processor_time * elements * size.steps / record.size.steps;
  cost.wall_time = cost.processor_time / cost.cores;
  cost.memory = record.memory * std::max(elements, 1.0);
}

// Writes two digits, or whole seconds.
std::string seconds_text(double seconds) {
  return seconds < 10 ? fmt::format("{:.2g}", seconds) : fmt::format("{:.0f}", seconds);
}

}  // namespace

ExpectedCost expected_cost(const CaseDefinition& definition, const RunDefinition& run,
                           const std::string& key, const ResultStore& store) {
  ExpectedCost cost;
  if (const auto* mesh = std::get_if<InterFoamRun>(&run.solver)) cost.cores = mesh->processes;
  if (const auto* external = std::get_if<ExternalRun>(&run.solver)) {
    cost.cores = external->cores.value_or(1);
    cost.own_limit = external->time_limit;
  }
  if (const auto earlier = store.newest_file(key, ".h5")) try {
      const RunCost taken = read_result(*earlier).cost;
      cost.processor_time = taken.core_seconds();
      cost.wall_time = taken.wall_time;
      cost.memory = taken.peak_memory;
      cost.measured = true;
      return cost;
    } catch (const ResultError&) {  // the file is damaged and says nothing
    }
  if (const auto record = last_record(work_family(run), store))
    scale(cost, *record, size_of(definition, run));
  return cost;
}

void record_cost(const RunResult& result, const CaseDefinition& definition,
                 const RunDefinition& run, const ResultStore& store) {
  const std::filesystem::path file = file_of(store);
  const Size size = size_of(definition, run);
  const bool ended_early = result.provenance.contains("left_range_because");
  if (ended_early || !(size.elements * size.steps > 0)) return;
  require_no_input(file);
  const bool is_there = std::filesystem::exists(std::filesystem::symlink_status(file));
  if (is_there && (std::filesystem::is_symlink(file) || !is_plain_file(file))) return;
  // A short line is one write, so that the lines of runs that end together do not mix.
  std::ofstream(file, std::ios::app)
      << fmt::format("{:.6g} {:.6g} {:.4g} {:.4g} {}\n", size.elements, size.steps,
                     result.cost.core_seconds(), result.cost.peak_memory, work_family(run));
}

std::string cost_text(const ExpectedCost& cost) {
  const std::string taken = seconds_text(cost.processor_time);
  if (cost.measured) return taken + " core-seconds measured";
  return cost.known() ? fmt::format("about {} core-seconds, scaled from another run", taken)
                      : "core-seconds not known";
}

double time_limit(const ExpectedCost& cost) {
  constexpr double shortest = 600, of_unknown = 72000;  // [s]
  // The run's own limit ends it first, and says so; its version_command may take a minute before.
  constexpr double beyond_own = 120;  // [s]
  if (cost.own_limit) return std::max(shortest, *cost.own_limit + beyond_own);
  return cost.measured || cost.known() ? std::max(shortest, 20 * cost.wall_time) : of_unknown;
}

}  // namespace slosh
