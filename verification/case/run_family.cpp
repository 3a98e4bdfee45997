#include "verification/case/run_family.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace slosh {

std::string changes_of(const SphRun& run) {
  std::vector<std::string> changes;
  if (!run.variant.empty()) changes.push_back(run.variant);
  if (!run.initial_state.empty()) changes.push_back("initial_state = " + run.initial_state);
  for (const auto& [name, number] : sph_number_names)
    if (const auto& value = run.numbers.*number)
      changes.push_back(fmt::format("{} = {:g}", name, *value));
  // Not the seed: repeats of one run change the same.
  if (run.start_disorder > unseen_disorder)
    changes.push_back(fmt::format("start_disorder = {:g}", run.start_disorder));
  return fmt::format("{}", fmt::join(changes, ", "));
}

std::string family(const RunDefinition& run) {
  if (const auto* sph = std::get_if<SphRun>(&run.solver)) return sph->scheme;
  if (std::holds_alternative<InterFoamRun>(run.solver)) return "interFoam";
  return run.name;
}

double resolution(const RunDefinition& run) {
  if (const auto* sph = std::get_if<SphRun>(&run.solver))
    return 1 / (sph->particle_spacing * sph->surface_particle_spacing);
  if (const auto* mesh = std::get_if<InterFoamRun>(&run.solver))
    return 1.0 * mesh->cells_x * mesh->cells_z;
  return 0;
}

bool is_changed(const RunDefinition& run) {
  const auto* sph = std::get_if<SphRun>(&run.solver);
  return sph && !changes_of(*sph).empty();
}

std::string work_family(const RunDefinition& run) {
  return is_changed(run) ? family(run) + ", " + changes_of(std::get<SphRun>(run.solver))
                         : family(run);
}

}  // namespace slosh
